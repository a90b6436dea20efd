"""Maps, a daemon of its own domain, and where things are."""

from __future__ import annotations

import itertools
import os
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

import mapd

WORKSPACE = Path(__file__).resolve().parents[3]
MAPS = WORKSPACE / "examples" / "maps"
# How long anything that must happen may take [s].
PATIENCE = 60.0
NUMBERS = itertools.count()
# What processes on board may say.
POLICY = """
[[allow]]
source = "camera"
kinds = ["closed"]
longest = 60

[[allow]]
source = "rain sensor"
kinds = ["wet"]
longest = 60
agree = 2
"""


def program() -> Path:
    """The daemon's program: MAPD_PROGRAM, else the debug build."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", WORKSPACE / "target"))
    place = Path(os.environ.get("MAPD_PROGRAM", target / "debug" / "mapd"))
    assert place.exists(), f"{place} is missing: cargo build -p mapd"
    return place


class Daemon:
    """A daemon that serves a copy of the town in a domain of its own."""

    def __init__(self, folder: Path, prefix: str) -> None:
        self.prefix = prefix
        self.file = folder / "town.xodr"
        self.file.write_bytes((MAPS / "town.xodr").read_bytes())
        self.environment = dict(os.environ, MAPD_PREFIX=prefix, MAPD_CACHE=str(folder / "cache"))
        self.start()

    def start(self) -> None:
        policy = self.file.with_name("policy.toml")
        policy.write_text(POLICY)
        command = [str(program()), "--load", str(self.file), "--overlay-from", str(policy)]
        self.process = subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def client(self) -> mapd.Client:
        return mapd.Client("town", timeout=PATIENCE, prefix=self.prefix)

    def wait_until_serving(self) -> None:
        """Until this daemon serves: what one before it has left can be attached to, too."""
        deadline = time.monotonic() + PATIENCE
        while True:
            with self.client() as client:
                if client.served_by == self.process.pid:
                    return
            assert time.monotonic() < deadline
            time.sleep(0.01)

    def swap(self) -> None:
        """Serves the town again, one street longer in name."""
        text = self.file.read_text()
        self.file.write_text(text.replace('name="Street ', 'name="Longer street ', 1))
        command = [str(program()), "reload", "town"]
        subprocess.run(command, env=self.environment, check=True, capture_output=True, timeout=PATIENCE)

    def kill(self) -> None:
        self.process.kill()
        self.process.wait(PATIENCE)

    def stop(self) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait(PATIENCE)


@pytest.fixture
def daemon(tmp_path: Path) -> Iterator[Daemon]:
    daemon = Daemon(tmp_path, f"py{os.getpid()}x{next(NUMBERS)}_")
    try:
        yield daemon
        # A daemon that was killed left files, which another one of its domain removes as it ends.
        if daemon.process.poll() is not None:
            daemon.start()
            daemon.wait_until_serving()
    finally:
        daemon.stop()


@pytest.fixture(scope="session")
def town() -> mapd.Map:
    return mapd.open(MAPS / "town.xodr")


LIGHTS = """<signals>
<signal id="5" name="light" s="20" t="-6" zOffset="3" dynamic="yes" orientation="+" type="1000001" subtype="-1" country="OpenDRIVE">
<dependency id="6" type="with"/><reference elementType="signal" elementId="6" type="pole"/></signal>
<signal id="6" name="sign" s="30" t="-6" zOffset="2" dynamic="no" orientation="+" type="205" subtype="-1" country="DE"/>
</signals></road>"""
CONTROLLER = '<controller id="c" name="lights" sequence="2"><control signalId="5" type="0"/></controller></OpenDRIVE>'


@pytest.fixture(scope="session")
def lights(tmp_path_factory: pytest.TempPathFactory) -> mapd.Map:
    """A road with a light that names a sign and has a controller, and user data."""
    text = (MAPS / "one_road.xodr").read_text().replace("</road>", LIGHTS, 1)
    path = tmp_path_factory.mktemp("lights") / "lights.xodr"
    path.write_text(text.replace("</OpenDRIVE>", '<userData code="says" value="this"/>' + CONTROLLER))
    return mapd.open(path)


@pytest.fixture(scope="session")
def other() -> mapd.Map:
    return mapd.open(MAPS / "objects.xodr")
