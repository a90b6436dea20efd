"""Where am I, and what is ahead? Asks a map that a daemon serves, or a file.

``where_am_i.py [SOURCE] [X Y]``: SOURCE is a file or the name of a served map, by default the town that comes with mapd.
"""

import sys
from pathlib import Path

import mapd

TOWN = Path(__file__).resolve().parents[1] / "maps" / "town.xodr"


def main(arguments: list[str]) -> None:
    source = arguments[0] if arguments else str(TOWN)
    x, y = (float(arguments[1]), float(arguments[2])) if len(arguments) > 2 else (50.0, -1.75)
    # A file is opened in place or compiled in memory; a served map is attached to.
    map = mapd.open(source) if Path(source).exists() else mapd.Client(source).map()
    print(map)

    hit = map.nearest_lane((x, y))
    if hit is None:
        print("no lane within 10 m")
        return
    print(f"on {hit.lane} at s = {hit.s:.2f} m, {hit.offset:+.2f} m beside its centre")
    limit = hit.lane.speed_rule_at(hit.s).max
    print("speed limit", "unknown" if limit is None else f"{limit * 3.6:.0f} km/h")

    for lanes in map.lane_sequences_ahead(hit, 150.0):
        print("ahead:", " > ".join(lane.key for lane in lanes))
    for ahead in map.signals_ahead(hit, 150.0):
        print(f"in {ahead.distance:.1f} m: {ahead.signal}")


if __name__ == "__main__":
    main(sys.argv[1:])
