# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs of ParaView on several ranks, none of which outlives its test."""

import gc
import os
import re
import subprocess
import threading

from paraview import servermanager, simple

RANKS = int(os.environ["FLIPFLOP_RANKS"])
PATIENCE = 120  # seconds: less than ctest has


def start(program, *arguments, environment=os.environ):
    """Start a program (pvbatch, pvserver) on all ranks, whose programmable sources find the modules here."""
    here = os.path.dirname(os.path.abspath(__file__))
    environment = {**environment, "PYTHONPATH": f"{here}:{environment['PYTHONPATH']}"}
    folder = os.path.dirname(os.environ["FLIPFLOP_PVPYTHON"])
    # mpiexec ends its ranks when it is told to: after a time, when this process ends, or by stop().
    command = ["setpriv", "--pdeathsig", "TERM", "timeout", "--kill-after=5", str(PATIENCE)]
    command += [os.environ["FLIPFLOP_MPIEXEC"], "-n", str(RANKS), os.path.join(folder, program), *arguments]
    return subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment
    )


def stop(process):
    """End a program that start() gave, if it still runs."""
    process.terminate()
    process.wait()
    process.stdout.close()


class Server:
    """A pvserver on all ranks, and this process its client."""

    def __init__(self, environment=os.environ):
        self.process = start("pvserver", "--server-port=0", environment=environment)
        self.output = []
        self.port = None
        self.listens = threading.Event()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()
        self.listens.wait()
        if self.port is None or simple.Connect("localhost", self.port) is None:
            raise RuntimeError("no connection to pvserver:\n" + "".join(self.output))

    def _read(self):
        """Keep what the server says; it says which free port it took."""
        for line in self.process.stdout:
            self.output.append(line)
            found = re.match(r"Accepting connection\(s\): .*:(\d+)", line)
            if found:
                self.port = int(found[1])
                self.listens.set()
        self.listens.set()

    def close(self):
        """Disconnect, which ends a server. Returns with what it ended. No test may hold a proxy then."""
        while simple.GetSources():
            simple.Delete(simple.GetSources().popitem()[1])
        gc.collect()
        session = servermanager.ActiveConnection.Session
        simple.Disconnect()
        session.CloseSession()  # what is left of proxies would keep it open
        self.process.wait()
        self.reader.join()
        self.process.stdout.close()
        return self.process.returncode
