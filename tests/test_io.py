"""Files of a motion: the same bits back, whole tables for other readers, clear refusals."""

import copy
import json
import os
import re

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import hophoop as hh
from checkout import text_of
from damage import same
from hophoop import cite, io
from hophoop.vocabulary.quantities import EVENT_UNITS

FORMATS = ["hop.nc", "hop.zarr", "hop.zarr.zip"]


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(hh.Hoop(), hh.Plane(restitution=0.4), hh.Start.rolling(3.1), duration=3.0)


# --- round trips -----------------------------------------------------------------------------------

MOTIONS = {
    "hop": "duration=3&plane.restitution=0.4",
    "compliant": "duration=0.3&start.height=0.02&start.omega=3&contact.model=compliant&contact.stiffness=1e4"
    "&contact.restitution=0.5",
    "undetermined": "duration=3&hoop.load_fraction=1&plane.mu=3&start.speed=-2",
    "at rest": "duration=3&hoop.load_fraction=1&plane.mu=inf&start.speed=2",
    "parts": "duration=1&plane.mu=0.7&start.speed=1&hoop.radius=0.3&hoop.parts.0.shape=ring&hoop.parts.0.mass=0.4"
    "&hoop.parts.0.inner_radius=0.28&hoop.parts.0.outer_radius=0.3&hoop.parts.1.shape=disk&hoop.parts.1.mass=0.5"
    "&hoop.parts.1.radius=0.02&hoop.parts.1.at=0.27",
}


@pytest.mark.parametrize(
    ("name", "kind"), [*(("hop.nc", kind) for kind in MOTIONS), ("hop.zarr", "compliant"), ("hop.zarr.zip", "hop")]
)
def test_a_loaded_motion_is_the_same_to_the_last_bit(tmp_path, name, kind):
    motion = hh.simulate(hh.Scenario.from_query(MOTIONS[kind]))
    motion.save(str(tmp_path / name))
    loaded = hh.load(tmp_path / name, check_fingerprint=True)
    assert same(motion, loaded)
    assert loaded.fingerprint == motion.fingerprint == motion.to_xarray(n=2).attrs["fingerprint"]
    assert os.listdir(tmp_path) == [name]


# --- what other readers find -----------------------------------------------------------------------


def test_the_dataset_describes_itself(motion):
    dataset = motion.to_xarray(n=50)
    sample = motion.at(dataset.time.values)
    assert dataset.sizes == {"time": 50}
    for name, variable in dataset.variables.items():
        assert variable.attrs["units"], name
        assert variable.attrs["long_name"], name
        if name not in ("time", "mode"):
            np.testing.assert_array_equal(variable.values, getattr(sample, name))
    letters = np.array(dataset["mode"].attrs["flag_letters"].split())
    assert dataset["mode"].attrs["flag_meanings"].split()[0] == "roll"
    np.testing.assert_array_equal(letters[dataset["mode"].values], sample.mode)
    assert json.loads(dataset.attrs["scenario"]) == motion.scenario.to_dict()
    assert dataset.attrs["schema"] == "hophoop/1"
    assert dataset.attrs["version"] == hh.__version__
    assert set(json.loads(dataset.attrs["provenance"])) == {"python", "numpy", "kernels", "machine"}
    times = [0.0, 0.5, motion.duration]
    np.testing.assert_array_equal(motion.to_xarray(t=times).time, times)
    assert io.to_xarray(motion, 0.5).sizes == {"time": 1}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", ["hop.nc", "hop.zarr"])
def test_plain_xarray_reads_the_tables_in_si(motion, tmp_path, name):
    scaled = hh.simulate(hh.Hoop.ideal(0.6, radius=0.3, mass=2.0), hh.Plane(gravity=3.0), hh.Start.rolling(1.2), duration=2.0)
    scaled.save(tmp_path / name)
    engine = "netcdf4" if name.endswith("nc") else "zarr"
    options = {"engine": engine}
    with xr.open_dataset(tmp_path / name, **options) as dataset:
        assert dataset.sizes == {"time": 1000}
        np.testing.assert_array_equal(dataset.angle, scaled.to_xarray().angle)
    with xr.open_dataset(tmp_path / name, group="events", **options) as events:
        for field in ("t", "x", "vx", "omega", "friction"):
            expected = [getattr(event, field) for event in scaled.events]
            np.testing.assert_allclose(events[field], expected, rtol=1e-14, atol=1e-14)
            assert events[field].attrs["units"] == EVENT_UNITS[field]
        words = events["kind"].attrs["flag_meanings"].split()
        assert [words[kind] for kind in events["kind"].values] == [event.kind for event in scaled.events]


def test_csv_over_time_and_of_events(motion, tmp_path):
    io.write_csv(motion, tmp_path / "hop.csv", motion.times(7))
    table = pd.read_csv(tmp_path / "hop.csv", dtype=str)
    assert list(table)[:4] == ["t [s]", "mode", "x [m]", "height [m]"]
    sample = motion.at(motion.times(7))
    np.testing.assert_array_equal(table["omega [rad/s]"].astype(float), sample.omega)
    np.testing.assert_array_equal(table["mode"], sample.mode)
    io.write_events_csv(motion, tmp_path / "events.csv")
    table = pd.read_csv(tmp_path / "events.csv", dtype=str)
    assert list(table["kind"]) == [event.kind for event in motion.events]
    impact, event = table[table["kind"] == "impact"].iloc[0], motion.find("impact")[0]
    assert float(impact["before_vy [m/s]"]) == event.before.vy
    assert float(impact["impulse_normal [N s]"]) == event.impulse_normal
    assert impact["collision"] == "True"


# --- refusals and half-written files ---------------------------------------------------------------


@pytest.mark.parametrize("name", ["hop.txt", "hop", "hop.nc.gz"])
def test_other_endings_are_refused(motion, tmp_path, name):
    sentence = r"must end in \.nc \(netCDF\), \.zarr or \.zarr\.zip \(Zarr\)\.$"
    with pytest.raises(ValueError, match=sentence):
        motion.save(tmp_path / name)
    with pytest.raises(ValueError, match=sentence):
        hh.load(tmp_path / name)
    assert not os.listdir(tmp_path)


@pytest.mark.parametrize("name", FORMATS)
def test_a_missing_file_or_folder_is_told_with_the_name_that_was_given(motion, tmp_path, name):
    """netCDF said 'Permission denied', of a name of our own."""
    missing = tmp_path / "gone" / name
    for call in (hh.load, motion.save):
        with pytest.raises(FileNotFoundError) as refusal:
            call(missing)
        assert refusal.value.filename == str(missing)


def test_a_store_does_not_replace_a_file(motion, tmp_path):
    (tmp_path / "hop.zarr").write_text("mine")
    with pytest.raises(NotADirectoryError):
        motion.save(tmp_path / "hop.zarr")
    assert [(file.name, file.read_text()) for file in tmp_path.iterdir()] == [("hop.zarr", "mine")]


# --- fingerprints ----------------------------------------------------------------------------------


def test_bits_that_this_machine_does_not_get_are_told(motion, tmp_path):
    """As if written on a machine that rounds otherwise; only a check that is asked for computes anything."""
    events = motion.tables["events"].copy()
    events["omega"][1] = np.nextafter(events["omega"][1], 9.0)
    other = hh.Trajectory(motion.scenario, motion._status, events, motion.tables["segments"], motion.version)
    other.save(tmp_path / "hop.nc")
    assert hh.load(tmp_path / "hop.nc").fingerprint == other.fingerprint != motion.fingerprint
    said = (
        f"was written by hophoop {hh.__version__} with the fingerprint {other.fingerprint}; "
        f"hophoop {hh.__version__} on this machine gets {motion.fingerprint}."
    )
    with pytest.raises(ValueError, match=re.escape(said)):
        hh.load(tmp_path / "hop.nc", check_fingerprint=True)


# --- what to cite ----------------------------------------------------------------------------------


def test_what_to_cite_is_citation_cff_with_the_version_of_the_motion(motion):
    entry = cite.cite()
    file = text_of("CITATION.cff")
    for name, field in (("title", "title"), ("  - name", "author"), ("version", "version"), ("license", "license")):
        (said,) = re.findall(rf'^{name}: "?([^"\n]*)"?$', file, re.MULTILINE)
        assert re.search(rf"^  {field} = {{{{?{re.escape(said)}}}?}},$", entry, re.MULTILINE), field
    older = copy.copy(motion)
    older.version = "0.0.9"
    assert cite.cite(motion) == entry
    assert cite.cite(older) == entry.replace(hh.__version__, "0.0.9")
