"""The measured cases, the variants in which Somato runs them, and the commands."""

from dataclasses import dataclass, field

THREADS = 2
BYTES_FOR_LARGE_FILE = 256 << 20
LARGE_ROWS, LARGE_COLUMNS, LARGE_SIDE = 1_000_000, 128, 200
CHAIN_SEEDS = 100


@dataclass
class Variant:
    """Another variant in which Somato runs a case, measured alternately with the first one."""

    name: str
    case: str = ""  # of workloads.cc; the row's own by default
    threads: int = THREADS
    set: str = ""  # of instructions; the fastest by default


@dataclass
class Row:
    """A case of workloads.cc; `half` marks those of which half of the epochs count."""

    name: str
    title: str
    variants: list = field(default_factory=list)
    half: bool = False
    minutes: float = 0.1  # approximate duration with all peers


@dataclass
class Command:
    """A whole run of the program; `words` follow its name."""

    name: str
    title: str
    words: list
    bytes: int = 0  # limit of memory; 0: none
    study: str = ""  # the system that it runs, with only the papers' protocol
    python: bool = False  # a task of peers/whole.py, by the Python package, instead of the program
    peers: dict = field(default_factory=dict)  # whole processes of others, and what they do instead
    repeats: int = 0  # if different from the default
    only_long: bool = False
    minutes: float = 0.5


# What the programs of others write in the place of text or Python's array.
WINNERS_ONLY = {"faiss": "writes winners only, in binary", "xpysom": "writes winners only, in binary",
                "minisom": "writes winners only, in binary"}

ONE_THREAD = Variant("1 thread", threads=1)


def slower_set(sets):
    """The second fastest instruction set, which does not use integer screening."""
    return [Variant(f"with {sets[-2]}", set=sets[-2])] if len(sets) > 1 else []


def rows(sets):
    """`sets`: the instruction sets of this machine, slowest first."""
    return [
        Row("dense_batch", "batch: 20000 x 256, map 50 x 50, 10 epochs",
            [ONE_THREAD, *slower_set(sets)], minutes=10),
        Row("hexagonal_batch", "hexagonal batch: 20000 x 256, map 50 x 50, 10 epochs", [ONE_THREAD], minutes=6),
        Row("few_samples", "online: 40 x 2049, map 15 x 15, 2000 iterations", minutes=2),
        Row("few_samples_streaming", "the few, a sample at a time", [ONE_THREAD]),
        Row("sparse_uniform_start",
            "sparse: 30 x 270000, 1 % not zero, map 15 x 15, 1000 iterations", minutes=3),
        Row("sparse_sample_start", "sparse, starting at samples", minutes=1),
        Row("sparse_streaming", "sparse, a sample at a time", minutes=1),
        Row("sparse_batch", "sparse, in batch, 33 epochs", minutes=5),
        Row("winners", "winners of 100000 x 64 on 50 x 50", [ONE_THREAD, *slower_set(sets)],
            minutes=4),
        Row("winners_manhattan", "Manhattan winners of 100000 x 64 on 50 x 50",
            [Variant("Euclidean", case="winners"), Variant("Chebyshev", case="winners_chebyshev"),
             Variant("cosine", case="winners_cosine")], minutes=0.3),
        Row("manhattan_batch", "Manhattan batch: 20000 x 256, map 50 x 50, 10 epochs",
            [Variant("Euclidean", case="dense_batch")], minutes=2),
        Row("many_online_manhattan", "Manhattan online: 20000 x 64, map 50 x 50, 20000 iterations",
            [Variant("Euclidean", case="many_online")], minutes=0.5),
        Row("layers_batch", "two layers, Euclidean and Manhattan, batch: 20000 x 64, map 50 x 50, 10 epochs", minutes=5),
        Row("layers_online", "the same layers online, 20000 iterations", minutes=5),
        Row("clustered_search", "winners: 50 clusters, second half of 10 batch epochs",
            [Variant("nothing left out", case="clustered_search_of_all")], half=True, minutes=0.3),
        Row("t_mpsom", "T-MPSOM: 46 x 23 neurons, 2000 frames learned"),
        Row("t_mpsom_large", "T-MPSOM: 460 x 230 neurons, 40 frames learned"),
    ]


def commands(data, out, quick):
    """`data` contains lucs2.mcap, studies and large.npy; `out` receives results, which are not used."""
    seeds = str(max(1, CHAIN_SEEDS // (20 if quick else 1)))
    side = str(LARGE_SIDE // (4 if quick else 1))
    recording = str(data / "lucs2.mcap")

    def chain(name, seeds):
        return ["run", str(data / f"{name}.toml"), "--data", recording, "--out", str(out / name),
                "--seeds", seeds]

    def task(name):
        return [name, str(data / "searches"), str(THREADS)]

    return [
        Command("som_map", "som map of 100000 x 64 on 50 x 50 with labels",
                ["som", "map", str(data / "searches/map.som"), str(data / "searches/samples.npy"),
                 "--output", str(out / "winners.csv"), "--threads", str(THREADS)], peers=WINNERS_ONLY),
        Command("predict", "predict of the same in Python", task("predict"), python=True,
                peers=WINNERS_ONLY),
        Command("classify", "classify of the same in Python", task("classify"), python=True),
        Command("transform", "transform of the same in Python, 1 GB", task("transform"), python=True),
        Command("apply", "a trained tensor chain applied to 30 explorations",
                ["apply", str(data / "chain/system.somato"), recording, "--threads", str(THREADS),
                 "--output", str(out / "answers.csv")], study="tensor_chain"),
        Command("tensor_chain", f"tensor chain, 30 explorations, {seeds} seeds",
                chain("tensor_chain", seeds), study="tensor_chain", minutes=0.5),
        Command("t_mpsom_chain", "T-MPSOM chain, 30 explorations, 1 seed",
                chain("t_mpsom_multiplied", "1"), study="t_mpsom_multiplied", minutes=0.1),
        Command("large_file", f"map {side} x {side} on a file larger than its memory, 1 epoch",
                ["som", "train", str(data / "large.npy"), "--output", str(out / "large.map"),
                 "--rows", side, "--columns", side, "--training", "batch", "--epochs", "1",
                 "--threads", str(THREADS)], BYTES_FOR_LARGE_FILE, repeats=1, minutes=1.5),
        Command("reproduce_all", "all systems of the papers, reproduced",
                ["reproduce", "all", "--out", str(out / "reproduction")], repeats=1,
                only_long=True, minutes=60),
    ]
