"""Attaching, following, and what may go wrong: as processes."""

from __future__ import annotations

import gc
import multiprocessing
import os
import resource
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from conftest import MAPS, PATIENCE, Daemon

import mapd

# Attachments after which the allocators hold what they need.
WARM = 1000
# Fewer bytes than one object that is lost with each attachment.
LEAK = 64
POINTS = np.column_stack([np.linspace(-10.0, 210.0, 2000), np.linspace(0.0, 200.0, 2000)])


def mappings(prefix: str) -> int:
    """Number of mappings of a domain's shared memory, or of a file, in this process."""
    return sum(prefix in line for line in Path("/proc/self/maps").read_text().splitlines())


def own_memory() -> int:
    """Bytes of memory of this process alone: what is in files and in shared memory does not count."""
    lines = Path("/proc/self/status").read_text().splitlines()
    (kilobytes,) = (line.split()[1] for line in lines if line.startswith("RssAnon:"))
    return 1024 * int(kilobytes)


def test_attach_and_ask(daemon: Daemon, town: mapd.Map) -> None:
    with daemon.client() as client:
        assert client.name == "town" and client.served_by == daemon.process.pid and client.pending is None
        age = client.heartbeat_age
        assert age is not None and 0 <= age < PATIENCE
        map = client.map()
        assert map.generation >= 1 and map.content_hash == town.content_hash
        assert np.array_equal(map.nearest_lane(POINTS).lane, town.nearest_lane(POINTS).lane)
        assert client.refresh().generation == map.generation
        assert client.require(map.generation).generation == map.generation
        client.populate()
        assert repr(client) == f'<mapd.Client "town" generation {map.generation}>'
    assert client.closed and repr(client) == '<mapd.Client "town" closed>'
    for call in (client.map, client.refresh, client.wait, client.events, lambda: client.pending, lambda: client.served_by, lambda: client.heartbeat_age):
        with pytest.raises(mapd.ClosedError):
            call()
    client.close()
    assert len(map.lanes()) == len(town.lanes())


def test_swaps_are_seen_and_what_is_held_stays(daemon: Daemon) -> None:
    client = daemon.client()
    events = client.events()
    before = client.map()
    assert events.wait(0.0) is None
    with pytest.raises(mapd.NoGenerationError, match="no generation newer"):
        client.wait(0.2)
    daemon.swap()
    event = events.wait(PATIENCE)
    assert isinstance(event, mapd.Generation) and event.map.generation == before.generation + 1
    after = client.map()
    assert after.generation == event.map.generation and after.content_hash != before.content_hash
    assert before.road("1").name == "Street 1" and after.road("1").name == "Longer street 1"
    with pytest.raises(mapd.ForeignIdError):
        after.lane(before.lanes()[0])
    assert after.lane(before.lanes()[0].key).key == before.lanes()[0].key
    with pytest.raises(mapd.SupersededError):
        daemon.client().require(before.generation, 1.0)


def test_a_killed_daemon_leaves_what_is_held(daemon: Daemon) -> None:
    client = daemon.client()
    events = client.events()
    map = client.map()
    want = map.nearest_lane(POINTS)
    lengths = mapd.raw.table(map, "roads")["length"]
    copy = lengths.copy()
    daemon.kill()
    event = events.wait(PATIENCE)
    assert isinstance(event, mapd.DaemonGone) and client.served_by is None
    assert np.array_equal(map.nearest_lane(POINTS).s, want.s, equal_nan=True)
    with pytest.raises(mapd.NoGenerationError, match="has ended"):
        client.wait(0.2)
    client.close()
    del map, client, events
    gc.collect()
    assert np.array_equal(lengths, copy)


@pytest.mark.parametrize(
    ("name", "prefix", "kind"),
    [
        ("town", "mapdpynobody_", mapd.NoDaemonError),
        ("no/name", "mapdpynobody_", mapd.BadNameError),
        ("", "mapdpynobody_", mapd.BadNameError),
        ("town", "no/prefix", mapd.BadNameError),
    ],
)
def test_what_cannot_be_attached_to(name: str, prefix: str, kind: type[Exception]) -> None:
    with pytest.raises(kind):
        mapd.Client(name, timeout=0.1, prefix=prefix)


def test_waits_that_are_none() -> None:
    for timeout in (-1.0, float("nan"), -float("inf")):
        with pytest.raises(ValueError, match="timeout"):
            mapd.Client("town", timeout=timeout, prefix="mapdpynobody_")


def test_waits_for_as_long_as_it_takes(daemon: Daemon) -> None:
    with mapd.Client("town", timeout=float("inf"), prefix=daemon.prefix) as client:
        newest = client.map().generation
        assert client.require(newest, float("inf")).generation == newest
    with pytest.raises(mapd.BadNameError):
        mapd.Client("no/name", timeout=float("inf"), prefix=daemon.prefix)


def test_a_map_that_is_not_served(daemon: Daemon) -> None:
    daemon.client()
    with pytest.raises(mapd.NoSuchMapError, match="town"):
        mapd.Client("village", timeout=0.5, prefix=daemon.prefix)


def test_too_few_descriptors_are_an_error_of_their_own(daemon: Daemon) -> None:
    daemon.client().close()
    gc.collect()
    used = len(os.listdir("/proc/self/fd"))
    usual = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, usual[1]))
    try:
        with pytest.raises(mapd.ExhaustedError, match="file descriptors"):
            mapd.Client("town", timeout=0.2, prefix=daemon.prefix)
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, usual)
    assert len(os.listdir("/proc/self/fd")) == used
    daemon.client().close()


def test_attaching_and_letting_go_leaves_no_mapping(daemon: Daemon, tmp_path: Path) -> None:
    daemon.client().close()
    gc.collect()
    before = mappings(daemon.prefix)
    descriptors = len(os.listdir("/proc/self/fd"))
    resident = 0
    for number in range(10_000):
        if number == WARM:
            gc.collect()
            resident = own_memory()
        client = daemon.client()
        map = client.map()
        hit, view = map.nearest_lane((50.0, -1.75)), mapd.raw.table(map, "lanes")
        # Reading all mappings takes longer than attaching.
        assert number % 100 or mappings(daemon.prefix) > before
        client.close()
        del client, map, hit, view
    gc.collect()
    assert mappings(daemon.prefix) == before and len(os.listdir("/proc/self/fd")) == descriptors
    assert own_memory() - resident < LEAK * (10_000 - WARM)
    archive = tmp_path / "town.mapd"
    mapd.compile(MAPS / "town.xodr").save(archive)
    for _ in range(1000):
        lane = mapd.open(archive).lanes()[0]
        assert mappings(str(archive)) == 1
        del lane
    assert mappings(str(archive)) == 0


def forked(work: Callable[[], None]) -> int:
    """Exit code of a forked process that runs something and ends as Python does."""
    child = os.fork()
    if child == 0:
        code = 1
        try:
            work()
            code = 0
        finally:
            gc.collect()
            os._exit(code)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_process_reads_what_it_inherits(daemon: Daemon) -> None:
    held = [daemon.client()]
    maps = [held[0].map()]
    events = [held[0].events()]
    want = maps[0].nearest_lane(POINTS)
    lengths = mapd.raw.table(maps[0], "roads")["length"]
    copy = lengths.copy()

    def child() -> None:
        assert np.array_equal(maps[0].nearest_lane(POINTS).s, want.s, equal_nan=True)
        assert np.array_equal(lengths, copy) and np.array_equal(mapd.raw.table(maps[0], "roads")["length"], copy)
        for call in (held[0].map, held[0].refresh, lambda: held[0].wait(0.1), lambda: events[0].wait(0.1)):
            with pytest.raises(mapd.ForkedError):
                call()
        assert "another process" in repr(held[0])
        mine = daemon.client()
        assert mine.map().generation == maps[0].generation
        mine.close()
        maps.clear()
        events.clear()
        held.clear()
        # The view alone keeps what it points into.
        gc.collect()
        assert np.array_equal(lengths, copy)
        # Compiling uses threads of its own, which a fork does not take away.
        assert mapd.compile(MAPS / "one_road.xodr").report.verdict == "accepted"

    assert forked(child) == 0
    daemon.swap()
    assert held[0].wait(PATIENCE).generation == maps[0].generation + 1
    assert np.array_equal(maps[0].nearest_lane(POINTS).s, want.s, equal_nan=True)


def test_threads_share_everything(daemon: Daemon) -> None:
    client = daemon.client()
    map = client.map()
    want = map.nearest_lane(POINTS).lane

    def ask(_: int) -> bool:
        newest = client.refresh()
        same = np.array_equal(newest.nearest_lane(POINTS).lane, newest.nearest_lane(POINTS).lane)
        return same and np.array_equal(map.nearest_lane(POINTS).lane, want)

    with ThreadPoolExecutor(8) as threads:
        asked = [threads.submit(ask, n) for n in range(40)]
        daemon.swap()
        assert all(one.result(PATIENCE) for one in asked)


def test_batches_let_other_threads_run(town: mapd.Map) -> None:
    many = np.tile(POINTS, (400, 1))
    call: list[float] = []

    def ask() -> None:
        begun = time.perf_counter()
        town.nearest_lane(many)
        call.extend((begun, time.perf_counter()))

    # A call that kept the lock would keep this thread from its clock for as long as it lasts; what other processes take from both is in both.
    thread = threading.Thread(target=ask)
    last, gap = time.perf_counter(), 0.0
    thread.start()
    while not call:
        now = time.perf_counter()
        last, gap = now, max(gap, now - last)
    thread.join(PATIENCE)
    begun, ended = call
    assert gap < 0.5 * (ended - begun)


@pytest.mark.parametrize("what", ["next(events)", "mapd.Client('town', timeout=float('inf'), prefix='mapdpynobody_')"])
def test_waiting_heeds_an_interrupt(daemon: Daemon, what: str) -> None:
    daemon.client().close()
    code = (
        "import mapd, signal, sys\n"
        # Who runs the tests in the background may ignore interrupts, and programs inherit that.
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"events = mapd.Client('town', timeout={PATIENCE}, prefix={daemon.prefix!r}).events()\n"
        f"try:\n    print('waiting', flush=True)\n    {what}\nexcept KeyboardInterrupt:\n    sys.exit(7)\n"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as waiting:
        try:
            assert waiting.stdout is not None and waiting.stdout.readline() == "waiting\n"
            waiting.send_signal(signal.SIGINT)
            assert waiting.wait(PATIENCE) == 7
        finally:
            waiting.kill()


def test_spawned_processes_attach_by_name(daemon: Daemon) -> None:
    map = daemon.client().map()
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        assert pool.starmap(generation_of, [(daemon.prefix,)] * 2) == [map.generation] * 2


def generation_of(prefix: str) -> int:
    with mapd.Client("town", timeout=PATIENCE, prefix=prefix) as client:
        return client.map().generation
