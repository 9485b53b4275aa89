"""A fixed job, whose processor time is the unit in which processor times of different machines are compared.

It parses, hashes, sorts and compresses text: branches, small objects and memory, as compilers and tests.
"""

import hashlib
import os
import re
import statistics
import sys
import time
import zlib
from concurrent.futures import ProcessPoolExecutor

REPEATS = 3
WORDS = re.compile(r"[a-f]+|\d+")


def text_of(seed):
    return "".join(hashlib.sha512(f"{seed} {line}".encode()).hexdigest() for line in range(400))


def work():
    """The job; returns a checksum, so that a test can show that it is the same work everywhere."""
    counts = {}
    digest = hashlib.sha256()
    for seed in range(16):
        text = text_of(seed)
        for word in WORDS.findall(text):
            counts[word] = counts.get(word, 0) + 1
        digest.update(zlib.decompress(zlib.compress(text.encode(), 6)))
    for word, count in sorted(counts.items(), key=lambda item: (item[1], item[0])):
        digest.update(f"{word} {count}\n".encode())
    return digest.hexdigest()


def processor_seconds(_=0):
    started = time.process_time()
    work()
    return time.process_time() - started


def measure():
    """Median of the job's processor seconds while all cores are busy with it, as they are with tests."""
    cores = os.cpu_count()
    with ProcessPoolExecutor(cores) as pool:
        return statistics.median(pool.map(processor_seconds, range(REPEATS * cores)))


if __name__ == "__main__":
    sys.exit(print(f"{measure():.3f} s"))
