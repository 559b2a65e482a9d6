# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as an array job of Slurm, on daemons of Slurm started here: `./sheetmorph test slurm`."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "package"))

from study_samples import contents, rows_of, write_study  # noqa: E402

from sheetmorph.cli import main  # noqa: E402

CONFIGURATION = """ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser={user}
AuthType=auth/none
CredType=cred/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/node.pid
SlurmdSpoolDir={folder}/spool
StateSaveLocation={folder}/state
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count: int) -> list[int]:
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


@pytest.fixture
def slurm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A controller and a node on loopback addresses."""
    folder = tmp_path / "slurm"
    for name in ("spool", "state"):
        (folder / name).mkdir(parents=True)
    text = CONFIGURATION.format(
        host=socket.gethostname().split(".")[0], ports=free_ports(2), folder=folder,
        user=os.environ.get("USER", "root"), cores=os.cpu_count(),
    )  # fmt: skip
    (folder / "slurm.conf").write_text(text)
    monkeypatch.setenv("SLURM_CONF", str(folder / "slurm.conf"))
    daemons = []
    try:
        with open(folder / "log", "w", encoding="utf-8") as log:
            for name in ("slurmctld", "slurmd"):
                place = shutil.which(name, path=f"{os.environ['PATH']}:/usr/sbin:/sbin")
                assert place, f"{name} is not installed"
                daemons.append(subprocess.Popen([place, "-D"], stdout=log, stderr=log))
            wait_for(lambda: "idle" in told("sinfo", "-h", "-o", "%t"), folder / "log")
            yield
    finally:
        for daemon in daemons:
            daemon.terminate()
            daemon.wait()


def told(*words: str) -> str:
    return subprocess.run(words, capture_output=True, text=True, check=False).stdout


def wait_for(done, log: Path, seconds: float = 90.0) -> None:
    end = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < end, log.read_text()
        time.sleep(0.3)


@pytest.mark.usefixtures("slurm")
def test_slurm_computes_the_array_and_writes_the_table(tmp_path: Path, capsys):
    path = write_study(tmp_path, sampling={"method": "sobol", "count": 16, "seed": 3})
    assert main(["study", str(path), "-o", str(tmp_path / "whole"), "--quiet"]) == 0
    whole = contents(tmp_path / "whole")
    out = tmp_path / "out"
    words = ["study", str(path), "-o", str(out), "--engine", "slurm", "--workers", "4"]
    assert main(words) == 0
    assert "16 run(s) in 4 job(s)" in capsys.readouterr().out
    wait_for((out / "summary.csv").exists, tmp_path / "slurm" / "log")
    wait_for(lambda: not told("squeue", "-h"), tmp_path / "slurm" / "log")
    made = contents(out)
    assert {name: made[name] for name in whole} == whole
    assert len(rows_of(out)) == 16
