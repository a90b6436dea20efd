"""What calls take, and how they refuse the rest."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import mapd

POINTS = np.array([[50.0, -1.75], [12.5, 3.0], [1e4, 1e4]])


@pytest.mark.parametrize(
    ("points", "kind", "says"),
    [
        (np.zeros((3, 4)), ValueError, "(N, 2) or (N, 3)"),
        (np.zeros(3), ValueError, "(N, 2) or (N, 3)"),
        (np.zeros((1, 2, 2)), ValueError, "(N, 2) or (N, 3)"),
        (np.float64(1.0), TypeError, "float64 of shape"),
        (np.zeros((3, 2), np.float32), TypeError, "float32"),
        (np.zeros((3, 2), np.int64), TypeError, "int64"),
        (np.zeros((3, 2), ">f8"), TypeError, ">f8"),
        (np.zeros((3, 2), object), TypeError, "object"),
        ([[1.0, 2.0]], TypeError, "list"),
        (None, TypeError, "NoneType"),
        ("12", TypeError, "str"),
        ((1.0,), ValueError, "tuple"),
        ((1.0, 2.0, 3.0, 4.0), ValueError, "tuple"),
        (("a", "b"), TypeError, ""),
        (np.array([[0.0, 0.0], [np.nan, 0.0]]), mapd.NotFiniteError, "row 1"),
        (np.array([[0.0, np.inf]]), mapd.NotFiniteError, "row 0"),
        ((np.nan, 0.0), mapd.NotFiniteError, "finite"),
    ],
)
def test_points_that_are_none(town: mapd.Map, points: Any, kind: type[Exception], says: str) -> None:
    for call in (town.nearest_lane, town.lanes_near, town.ground_at, town.nearest_mark, town.road("1").to_track):
        with pytest.raises(kind) as error:
            call(points)
        assert says in str(error.value)


def test_strides_and_alignment_do_not_matter(town: mapd.Map) -> None:
    want = town.nearest_lane(POINTS)
    packed = np.zeros(3, [("flag", "u1"), ("xy", "<f8", (2,))])
    packed["xy"] = POINTS
    wide = np.zeros((6, 4))
    wide[::2, ::2] = POINTS
    read_only = POINTS.copy()
    read_only.flags.writeable = False
    for points in (packed["xy"], wide[::2, ::2], np.asfortranarray(POINTS), POINTS[::-1][::-1], read_only):
        got = town.nearest_lane(points)
        for name in want.names:
            assert np.array_equal(got[name], want[name], equal_nan=True)


def test_empty_batches_have_empty_columns(town: mapd.Map) -> None:
    assert len(town.nearest_lane(np.empty((0, 2)))) == 0
    assert len(town.lanes_near(np.empty((0, 3)))) == 0
    assert town.nearest_lane(np.empty((0, 2))).lane.dtype == np.uint64


def test_a_tuple_is_one_and_an_array_many(town: mapd.Map) -> None:
    many = town.nearest_lane(POINTS)
    for row, (x, y) in enumerate(POINTS):
        one = town.nearest_lane((float(x), float(y)))
        if one is None:
            assert many.lane[row] == mapd.NONE and np.isinf(many.distance[row])
            continue
        assert one.lane.id == many.lane[row]
        assert (one.s, one.t, one.offset, one.distance, one.z, one.heading) == tuple(
            many[name][row] for name in ("s", "t", "offset", "distance", "z", "heading")
        )


def test_out_is_filled_again(town: mapd.Map) -> None:
    out = mapd.NearestLanes(3)
    column = out.s
    assert town.nearest_lane(POINTS, out=out) is out
    assert out.s is column
    assert np.array_equal(column, town.nearest_lane(POINTS).s, equal_nan=True)
    with pytest.raises(ValueError, match="expected 2 rows, found 3"):
        town.nearest_lane(POINTS[:2], out=out)
    with pytest.raises(TypeError, match="expected NearestLanes, found Poses"):
        town.nearest_lane(POINTS, out=mapd.Poses(3))  # type: ignore[call-overload]
    before = {name: array.copy() for name, array in dict(out).items()}
    moved = POINTS + 1.0
    moved[2] = np.nan
    with pytest.raises(mapd.NotFiniteError, match="row 2"):
        town.nearest_lane(moved, out=out)
    out.heading.flags.writeable = False
    with pytest.raises(ValueError, match="read-only"):
        town.nearest_lane(POINTS + 1.0, out=out)
    # An error leaves everything as it was, and the next call is as good as the first.
    assert all(np.array_equal(out[name], before[name], equal_nan=out[name].dtype.kind == "f") for name in out.names)
    out.heading.flags.writeable = True
    assert np.array_equal(town.nearest_lane(POINTS + 1.0, out=out).s, town.nearest_lane(POINTS + 1.0).s, equal_nan=True)


def test_answers_can_be_filled_again_and_pickled(town: mapd.Map) -> None:
    """What a call has made is as good an ``out`` as what a program makes, and what is kept with it is not copied."""
    hits = town.nearest_lane(POINTS)
    assert town.nearest_lane(POINTS[::-1], out=hits) is hits
    again = pickle.loads(pickle.dumps(hits))
    assert type(again) is mapd.NearestLanes and np.array_equal(again.lane, hits.lane)
    assert town.nearest_lane(POINTS, out=again) is again and np.array_equal(again.lane, hits.lane[::-1])


def test_batches_of_one(town: mapd.Map) -> None:
    hits = town.nearest_lane(POINTS[:1], heading=np.zeros(1))
    assert len(hits) == 1 and town.pose_at(hits.lane, hits.s, np.zeros(1)).x.shape == (1,)


def test_columns_convert(town: mapd.Map) -> None:
    hits = town.nearest_lane(POINTS)
    assert list(dict(hits)) == list(hits.names) == list(hits.to_dict())
    assert hits["s"] is hits.s
    pandas = pytest.importorskip("pandas")
    frame = hits.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.columns) == list(hits.names)
    polars = pytest.importorskip("polars")
    table = hits.to_polars()
    assert isinstance(table, polars.DataFrame) and table.columns == list(hits.names)
    assert all(np.array_equal(table[name].to_numpy(), hits[name], equal_nan=hits[name].dtype.kind == "f") for name in hits.names)
    with pytest.raises(AttributeError, match="no column 'nonsense'"):
        hits.nonsense
    assert "3 rows" in repr(hits) and "<table>" in hits._repr_html_()


def test_ids_of_another_content_are_refused(town: mapd.Map, other: mapd.Map) -> None:
    ids = np.array([lane.id for lane in other.lanes()], np.uint64)
    with pytest.raises(mapd.ForeignIdError):
        town.pose_at(ids, 0.0)
    with pytest.raises(mapd.ForeignIdError):
        town.lane(other.lanes()[0])
    with pytest.raises(mapd.ForeignIdError):
        town.lane(int(ids[0]))
    with pytest.raises(mapd.ForeignIdError):
        town.route((other.lanes()[0], 0.0), (town.lanes()[0], 0.0))
    none = np.array([mapd.NONE], np.uint64)
    with pytest.raises(mapd.QueryError, match="row 0"):
        town.pose_at(none, 0.0)
    with pytest.raises(TypeError, match="uint64"):
        town.pose_at(np.zeros(2), 0.0)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="shape"):
        town.pose_at(np.zeros((2, 2), np.uint64), 0.0)


def test_names_that_are_none(town: mapd.Map) -> None:
    for call in (lambda: town.lane("no:0:1"), lambda: town.road("no"), lambda: town.signal("no"), lambda: town.object("no")):
        with pytest.raises(mapd.NoSuchPartError, match="no"):
            call()
    with pytest.raises(ValueError, match="lane key"):
        town.lane("nonsense")
    with pytest.raises(TypeError, match="a lane, its key or its id"):
        town.lane(1.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="drivable"):
        town.nearest_lane((0.0, 0.0), types="nonsense")
    with pytest.raises(ValueError, match="passengerCar"):
        town.reachable((town.lanes()[0], 0.0), 10.0, vehicle="nonsense")
    with pytest.raises(ValueError, match="length"):
        town.reachable((town.lanes()[0], 0.0), 10.0, by="nonsense")  # type: ignore[arg-type]


def test_columns_are_asked_for_by_name(town: mapd.Map) -> None:
    hits = town.nearest_lane(POINTS)
    assert "s" in hits and "lane" in hits and "speed" not in hits and 0 not in hits
    assert list(hits) == list(hits.names) == list(dict(hits)) and len(hits) == len(POINTS)


def test_a_step_that_gives_too_many_waypoints_is_refused(town: mapd.Map) -> None:
    lane = town.lane("1:0:-1")
    for step in (1e-9, 1e-300):
        with pytest.raises(mapd.QueryError, match="step"):
            lane.waypoints(step)
    assert len(lane.waypoints(1.0)) == 77


def test_an_id_of_no_lane_is_not_a_foreign_one(town: mapd.Map) -> None:
    lanes = town.nearest_lane(POINTS).lane
    assert lanes[2] == mapd.NONE
    with pytest.raises(mapd.QueryError, match="row 2: the id names nothing"):
        town.pose_at(lanes, 1.0)


def test_only_lanes_count_that_the_vehicle_may_use(town: mapd.Map) -> None:
    lane = town.lane("1:0:-1")
    pose = town.pose_at(np.array([lane.id], np.uint64), 10.0)
    x, y = float(pose.x[0]), float(pose.y[0])
    car = town.nearest_lane((x, y), vehicle="passengerCar")
    on_foot = town.nearest_lane((x, y), vehicle="pedestrian")
    assert car is not None and car.lane == lane and (on_foot is None or on_foot.lane != lane)
    near = {hit.lane for hit in town.lanes_near((x, y), vehicle="pedestrian")}
    assert lane not in near and lane in {hit.lane for hit in town.lanes_near((x, y))}
    of_many = town.nearest_lane(np.array([[x, y]]), vehicle="passengerCar")
    assert of_many.lane[0] == lane.id
    with pytest.raises(ValueError, match="passengerCar"):
        town.nearest_lane((x, y), vehicle="car")


def test_landmarks_of_named_classes(other: mapd.Map) -> None:
    usual = other.landmarks_near((0.0, 0.0), 1e6)
    box = (-1e6, -1e6, 1e6, 1e6)
    assert usual and len(other.landmarks_in(box)) == len(usual)
    assert other.landmarks_near((0.0, 0.0), 1e6, classes=[]) == []
    for meaning in {one.meaning for one in usual}:
        named = other.landmarks_near((0.0, 0.0), 1e6, classes=[meaning])
        assert named == [one for one in usual if one.meaning == meaning]
    with pytest.raises(ValueError, match="nonsense"):
        other.landmarks_in(box, classes=["nonsense"])


def test_a_hint_changes_no_answer(town: mapd.Map) -> None:
    last = None
    for x in np.linspace(12.5, 60.0, 20):
        point = (float(x), -1.75)
        hit = town.nearest_lane(point, hint=last)
        assert hit is not None and hit == town.nearest_lane(point)
        last = hit
    with pytest.raises(TypeError, match="hint"):
        town.nearest_lane((50.0, -1.75), hint="1:0:-1")  # type: ignore[call-overload]
    with pytest.raises(ValueError, match="hint"):
        town.nearest_lane(POINTS, hint=last)  # type: ignore[call-overload]
