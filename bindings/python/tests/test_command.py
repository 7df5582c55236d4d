"""The command of the wheel: what the program's binary does, and what it says of itself."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import tribos
from test_runs import LONG

BINARY = Path(__file__).parents[3] / "target" / "debug" / "tribos"


def command(*arguments: str, **options: object) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, "-m", "tribos", *arguments]
    return subprocess.run(line, capture_output=True, text=True, **options)  # type: ignore[call-overload,no-any-return]


@pytest.mark.parametrize(
    ("line", "code", "words"),
    [
        (["--version"], 0, f"tribos {tribos.__version__}"),
        (["wrench", "--help"], 0, "Usage: tribos wrench"),
        (["laws"], 0, "coulomb"),
        (["run", "disk", "--out", "OUT", "--set", "speed=-1"], 2, "`speed` must be"),
        (["fly"], 2, "unrecognized subcommand"),
    ],
)
def test_it_ends_with_the_binarys_code_and_words(
    line: list[str], code: int, words: str, tmp_path: Path
) -> None:
    line = [str(tmp_path / "out") if word == "OUT" else word for word in line]
    done = command(*line)
    assert done.returncode == code and words in done.stdout + done.stderr
    if BINARY.exists():
        same = subprocess.run([str(BINARY), *line], capture_output=True, text=True)
        assert (same.returncode, same.stdout) == (done.returncode, done.stdout)


def test_all_of_a_long_output_reaches_a_pipe() -> None:
    keys = command("scene", "schema", "powder").stdout
    assert keys.rstrip().endswith("}") and len(keys) > 5000


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_ctrl_c_leaves_a_checkpoint_and_the_exit_code_of_a_shell(tmp_path: Path) -> None:
    file, out = tmp_path / "powder.toml", tmp_path / "out"
    file.write_text(LONG.replace(max_steps=100_000, width=20.0, height=61.5).to_toml())
    line = [sys.executable, "-m", "tribos", "run", str(file), "--out", str(out)]
    with subprocess.Popen(line, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as run:
        until = time.monotonic() + 10.0
        lock = out / ".tribos-lock"
        while not (out / "frames").exists() and time.monotonic() < until:
            time.sleep(0.01)
        # Others are told which command holds the folder.
        told = lock.read_text()
        assert re.match(rf"process {run.pid}, `tribos run .*powder.toml --out .*`, since 20", told)
        with pytest.raises(ValueError, match="in use by process .*`tribos run"):
            tribos.run("disk", out)
        run.send_signal(signal.SIGINT)
        _, told = run.communicate(timeout=20)
    assert run.returncode == 130
    assert "interrupted after step" in told and "--resume" in told
    assert (out / "checkpoint.json").exists() and not lock.exists()


def test_a_lock_names_the_program_that_holds_it(tmp_path: Path) -> None:
    seen: list[str] = []

    def look(done: float | None, words: str) -> None:
        seen.append((tmp_path / ".tribos-lock").read_text())
        raise StopIteration

    with pytest.raises(StopIteration):
        tribos.run(
            LONG.replace(max_steps=100_000, width=20.0, height=61.5), tmp_path, progress=look
        )
    assert f"process {os.getpid()}, `python " in seen[0]


def test_a_job_script_starts_the_command_and_not_the_interpreter(tmp_path: Path) -> None:
    bin_ = tmp_path / "bin"
    bin_.mkdir()
    script = bin_ / "tribos"
    script.write_text(f"#!{sys.executable}\nfrom tribos._command import main\nmain()\n")
    script.chmod(0o755)
    out = tmp_path / "sweep"
    line = ["sweep", "disk", "--set", "spin=1,2", "--out", str(out), "--slurm"]
    subprocess.run([str(script), *line], check=True, capture_output=True)
    text = (out / "job.sh").read_text()
    assert f"program='{script}'" in text
    # The script that it names runs a task.
    environment = {**os.environ, "SLURM_ARRAY_TASK_ID": "0", "SLURM_CPUS_PER_TASK": "1"}
    subprocess.run(["bash", str(out / "job.sh")], check=True, env=environment, capture_output=True)
    assert len(list((out / "runs").rglob("summary.json"))) == 1
    path = {**os.environ, "PATH": f"{bin_}{os.pathsep}{os.environ['PATH']}"}
    beside = Path(sys.executable).parent / "tribos"
    found = beside if beside.is_file() else script
    assert command(*line, env=path).returncode == 0
    assert f"program='{found}'" in (out / "job.sh").read_text()
