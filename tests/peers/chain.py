"""The program peer_chain, and a port through which a maker's library talks to it without a clock."""

import os
import subprocess


class Chain:
    """Emulated servos with the ids 1, 2, ..., and a bus of ours that drives them."""

    def __init__(self, kind, servos):
        self.process = subprocess.Popen([os.environ["SOMATO_PEER_CHAIN"], kind, str(servos)],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()

    def ask(self, *words):
        print(*words, file=self.process.stdin, flush=True)
        answer = self.process.stdout.readline()
        if not answer:
            raise RuntimeError(f"peer_chain ended at: {words}")
        return answer.strip()

    def bytes(self, *words):
        return bytes.fromhex(self.ask(*words))


class Port:
    """The port that the libraries of both makers expect. The servos' answers are available at once;
    when it is used up, the time is over."""

    def __init__(self, chain=None):
        self.chain = chain
        self.is_using = False
        self.sent = []
        self.incoming = b""

    def clearPort(self):
        self.incoming = b""

    def writePort(self, packet):
        self.sent.append(bytes(packet))
        if self.chain:
            self.incoming += self.chain.bytes("send", self.sent[-1].hex())
        return len(packet)

    def readPort(self, length):
        taken, self.incoming = self.incoming[:length], self.incoming[length:]
        return taken

    def getBytesAvailable(self):
        return len(self.incoming)

    def getBaudRate(self):
        return 1_000_000

    def setPacketTimeout(self, _length):
        pass

    def setPacketTimeoutMillis(self, _milliseconds):
        pass

    def isPacketTimeout(self):
        return True
