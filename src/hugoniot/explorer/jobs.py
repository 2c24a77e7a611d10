"""Runs started from the page: each in a process of its own, with the same reading of the deck and the same limits as `hugoniot run`."""

import contextlib
import itertools
import json
import re
import subprocess
import sys
import threading
from collections import deque
from pathlib import Path
from typing import Any

from hugoniot.errors import FileTrouble
from hugoniot.explorer.decks import read
from hugoniot.explorer.places import Places
from hugoniot.explorer.worker import COMMAND

MOST_AT_ONCE = 2
LINES = 40


class Job:
    """One process: `shown()` says how far it is."""

    def __init__(self, text: str, folder: Path, places: Places):
        self.folder, self.places, self.stopping = folder, places, False
        self.run: int | None = None
        self.progress: dict[str, Any] = {}
        self.lines: deque[str] = deque(maxlen=LINES)
        # -P: modules come from where Python has them, never from the folder of the runs
        command = [sys.executable, "-P", "-c", COMMAND, str(folder)]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                        encoding="utf-8", errors="replace", cwd=folder.parent)
        self.reader = threading.Thread(target=self._read, args=(text,), daemon=True)
        self.reader.start()

    def _read(self, text: str) -> None:
        stdin, stdout = self.process.stdin, self.process.stdout
        if stdin is None or stdout is None:
            return
        with contextlib.suppress(OSError):
            stdin.write(text)
            stdin.close()
        for line in stdout:
            try:
                news = json.loads(line)
            except ValueError:
                self.lines.append(line.rstrip())
                continue
            if isinstance(news, dict) and "message" in news:
                self.lines += str(news["message"]).splitlines()
            elif isinstance(news, dict):
                self.progress = news
        self.process.wait()

    @property
    def running(self) -> bool:
        return self.process.poll() is None

    def shown(self) -> dict[str, Any]:
        """State, progress and messages; the number of the run once its folder is there."""
        if self.run is None and (self.folder / "deck.toml").is_file():
            self.run = self.places.add_run(self.folder)
        code = self.process.poll()
        state = "running" if code is None else "done" if code == 0 else "stopped" if self.stopping or code == 130 else "failed"
        if code is not None:
            self.reader.join(2.0)
        return {"state": state, "code": code, "progress": self.progress, "lines": list(self.lines), "run": self.run,
                "name": self.folder.name}

    def stop(self) -> None:
        """Ask the run to end with a checkpoint, as Ctrl-C does."""
        self.stopping = True
        if self.running:
            self.process.terminate()


class Jobs:
    """The runs started from the page, by number."""

    def __init__(self, places: Places):
        self.places, self.jobs, self._lock = places, [], threading.Lock()

    def start(self, text: str) -> dict[str, Any]:
        """Start a run of a deck in a new folder of the working folder; DeckError with every problem, `FileTrouble` where none may run."""
        work = self.places.work
        if work is None:
            raise FileTrouble("no folder for runs was given: start hugoniot explore with --work FOLDER")
        found = read(text, work)
        with self._lock:
            if sum(job.running for job in self.jobs) >= MOST_AT_ONCE:
                raise FileTrouble(f"{MOST_AT_ONCE} runs are in progress: wait for one to end, or stop it")
            work.mkdir(parents=True, exist_ok=True)
            self.jobs.append(Job(text, _free_folder(work, found.problem.title), self.places))
            return {"job": len(self.jobs) - 1}

    def job(self, number: int) -> Job:
        """A job by its number; `FileTrouble` for any other."""
        if not 0 <= number < len(self.jobs):
            raise FileTrouble(f"no run {number} was started here")
        return self.jobs[number]

    def close(self) -> None:
        """End every run with a checkpoint."""
        for job in self.jobs:
            if job.running:
                job.stop()
        for job in self.jobs:
            with contextlib.suppress(subprocess.TimeoutExpired):
                job.process.wait(20.0)


def _free_folder(work: Path, title: str) -> Path:
    """A run folder that is not there yet, named after the title of the deck in letters and digits alone."""
    stem = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")[:40].strip("-") or "run"
    for suffix in itertools.chain([""], (f"-{k}" for k in itertools.count(2))):
        folder = work / f"{stem}{suffix}.run"
        if not folder.exists():
            return folder
    raise FileTrouble(f"{work}: no name is free for a new run folder")
