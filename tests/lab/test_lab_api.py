"""The lab's programming interface: results, errors in one sentence, limits, caching, no file but its own."""

import json
import pickle
import re
from concurrent.futures import Future
from dataclasses import replace

import pytest

fastapi = pytest.importorskip("fastapi", reason="the extra 'lab' is not installed")
pytest.importorskip("httpx", reason="httpx is not installed")
from fastapi.testclient import TestClient  # noqa: E402

import hophoop as hh  # noqa: E402
from hophoop._support.extras import MissingExtra, install_command, need  # noqa: E402
from hophoop.lab.api import calls, packing  # noqa: E402
from hophoop.lab.api.limits import USUAL  # noqa: E402
from hophoop.lab.server import app, routes  # noqa: E402
from hophoop.lab.server.pool import Pool  # noqa: E402
from hophoop.scenario import InputError  # noqa: E402
from hophoop.theory.summary import summary_dict  # noqa: E402


@pytest.fixture(scope="module")
def client():
    with asking(routes.create_app()) as client:
        yield client


def asking(application):
    return TestClient(application, base_url="http://localhost")


def test_simulate_gives_the_result_file(client):
    reply = client.post("/api/v1/simulate", json={"duration": 2.0})
    assert reply.status_code == 200
    expected = hh.simulate(hh.Scenario(duration=2.0)).to_dict()
    assert reply.json() == json.loads(json.dumps(expected))


def test_simulate_samples_on_request(client):
    got = client.post("/api/v1/simulate?samples=5", json={"duration": 2.0}).json()["samples"]
    motion = hh.simulate(hh.Scenario(duration=2.0))
    assert got["t"] == [0.0, 0.5, 1.0, 1.5, 2.0]
    assert got["x"] == motion.at(got["t"]).x.tolist()
    assert got["mode"] == motion.at(got["t"]).mode.tolist()


def test_an_empty_body_is_the_reference_case(client):
    assert client.post("/api/v1/simulate").json()["sequence"] == hh.simulate(hh.Scenario()).sequence


@pytest.mark.parametrize(
    ("path", "body", "status", "said"),
    [
        ("/api/v1/simulate", {"hoop": {"mass": -1.5}}, 422, "hoop.mass = -1.5 must be greater than 0."),
        ("/api/v1/simulate", {"hop": 1}, 422, "hop is not a known key; did you mean hoop?"),
        ("/api/v1/simulate", [], 422, "the scenario = [] must be a table of keys."),
        ("/api/v1/simulate", {"duration": 1e9}, 413, "duration = 1e+09 must be at most 600 s"),
        ("/api/v1/simulate?samples=1", {}, 422, "samples = '1' must be a whole number from 0 and not 1."),
        ("/api/v1/simulate?samples=x", {}, 422, "samples = 'x' must be a whole number."),
        ("/api/v1/simulate?samples=30000", {}, 413, "samples = 30000 must be at most 20001"),
        ("/api/v1/theory", {"plane": {"mu": "high"}}, 422, "plane.mu = 'high' must be a number."),
        ("/api/v1/map", {}, 422, "x is missing (and 1 more problem)."),
        ("/api/v1/simulate?samples=-2", {}, 422, "samples = '-2' must be at least 0."),
        ("/api/v1/theory", 3, 422, "the scenario = 3 must be a table of keys."),
        ("/lab/motion", 3, 422, "the scenario = 3 must be a table of keys."),
        ("/lab/motion", {"changes": 1}, 422, "changes = 1 must be a list"),
        ("/lab/motion", {"scenario": {"contact": {"model": "soft"}}}, 422, "contact.model = 'soft' must be 'rigid' or"),
        (
            "/lab/motion",
            {"changes": [["hoop.radius", -1.5], ["start.omega", 2]]},
            422,
            "hoop.radius = -1.5 must be greater than 0.",
        ),
        ("/lab/film", {}, 404, "Not Found"),
        # JSON's words, not Python's
        ("/api/v1/simulate", {"duration": None}, 422, "duration = null must be a number."),
        ("/api/v1/simulate", {"duration": True}, 422, "duration = true must be a number."),
        ("/api/v1/theory", {"hoop": [None, {"a": False}]}, 422, "hoop = [null, {'a': false}] must be a table of keys."),
        ("/lab/motion", {"changes": [["plane.mu", False]]}, 422, "plane.mu = false must be a number."),
    ],
)
def test_errors_are_one_sentence(client, path, body, status, said):
    reply = client.post(path, json=body)
    assert reply.status_code == status
    assert list(reply.json()) == ["detail"]
    assert said in reply.json()["detail"]


@pytest.mark.parametrize(
    "body",
    [
        b"{",
        b"NaN",
        b'{"duration": Infinity}',
        b"\xff",
        b"[" * 50_000,
        b"9" * 5000,
        b'{"plane": {"mu": 1, "slope": 0, "mu": 2}}',
    ],
)
def test_what_is_not_json_is_said(client, body):
    reply = client.post("/api/v1/simulate", content=body, headers={"Content-Type": "application/json"})
    assert reply.status_code == 422
    assert "not valid JSON" in reply.json()["detail"]
    assert "sys." not in reply.json()["detail"]


def test_a_key_given_twice_is_named(client):
    body = b'{"plane": {"mu": 1, "slope": 0, "mu": 2}}'
    reply = client.post("/api/v1/simulate", content=body, headers={"Content-Type": "application/json"})
    assert reply.json() == {"detail": 'The body is not valid JSON: it gives the key "mu" twice.'}


def test_a_body_has_its_limit(client):
    reply = client.post("/api/v1/simulate", content=b" " * (USUAL.body + 1), headers={"Content-Type": "application/json"})
    assert reply.status_code == 413
    assert "more than 65536 bytes" in reply.json()["detail"]


def test_other_content_is_refused(client):
    for kind in ("text/csv", "text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", ""):
        reply = client.post("/api/v1/simulate", content=b"{}", headers={"Content-Type": kind} if kind else {})
        assert reply.status_code == 415, kind
        assert "must be application/json" in reply.json()["detail"]


def test_a_compressed_body_is_refused(client):
    for coding, status in {"gzip": 415, "br": 415, "gzip, identity": 415, "identity": 200}.items():
        headers = {"Content-Type": "application/json", "Content-Encoding": coding}
        reply = client.post("/api/v1/theory", content=b"{}", headers=headers)
        assert reply.status_code == status, coding
        if status == 415:
            assert reply.json()["detail"] == f"Content-Encoding = '{coding}' must be identity: send the body as it is."


def test_half_a_character_is_refused(client):
    for body in (b'{"start": {"\\ud800": 1}}', b'{"hoop": "\\udfff"}', b'[["\\ud800"]]'):
        for path in ("/api/v1/simulate", "/api/v1/theory", "/lab/motion"):
            reply = client.post(path, content=body, headers={"Content-Type": "application/json"})
            assert reply.status_code == 422
            assert "not valid JSON" in reply.json()["detail"]
    whole = client.post("/api/v1/simulate", content=b'{"\\ud83d\\ude00": 1}', headers={"Content-Type": "application/json"})
    assert "😀 is not a known key" in whole.json()["detail"]


def test_equal_scenarios_have_equal_tags(client):
    one = client.post("/api/v1/simulate", json={"duration": 1.0})
    two = client.post("/api/v1/simulate", json={"plane": {"mu": 1.0}, "duration": 1})
    other = client.post("/api/v1/simulate", json={"duration": 1.5})
    assert one.headers["etag"] == two.headers["etag"] != other.headers["etag"]
    assert one.content == two.content
    known = client.post("/api/v1/simulate", json={"duration": 1.0}, headers={"If-None-Match": one.headers["etag"]})
    assert known.status_code == 304
    assert known.content == b""


def test_theory_and_map_answer(client):
    found = client.post("/api/v1/theory", json={}).json()
    critical = hh.theory.critical_speeds(hh.Hoop(), hh.Plane())
    assert found["theory"]["first_slip_speed"] == critical.first_slip
    assert found == json.loads(json.dumps(summary_dict(hh.Scenario())))
    assert client.post("/api/v1/theory", json={"plane": {"mu": "inf"}}).json()["theory"]["immediate_hop_speed"] > 0.0
    body = {
        "x": {"path": "start.speed", "from": 0.0, "to": 5.0, "cells": 4},
        "y": {"path": "plane.mu", "from": 0.2, "to": 1.0, "cells": 3},
    }
    got = client.post("/api/v1/map", json=body)
    assert [len(row) for row in got.json()["values"]] == [4, 4, 4]
    packed = client.post("/api/v1/map", json=body, headers={"Accept": "application/octet-stream"})
    header, arrays = packing.unpack(packed.content)
    assert arrays["values"].tolist() == got.json()["values"]
    assert header["classes"] == got.json()["classes"]
    assert packed.headers["etag"] != got.headers["etag"]


def test_files_are_served_by_name_only(client):
    got = client.get("/api/v1/files/motion.toml?start.speed=2")
    assert hh.Scenario.loads(got.text) == hh.Scenario(start=hh.Start.rolling(2.0))
    assert "hophoop-motion.toml" in got.headers["content-disposition"]
    again = client.get("/api/v1/files/motion.toml?start.speed=2", headers={"If-None-Match": got.headers["etag"]})
    assert again.status_code == 304
    assert client.get("/api/v1/files/motion.csv?start.speed=x").status_code == 422
    for name in ("motion.exe", "..%2f..%2fpyproject.toml", "%2fetc%2fpasswd"):
        assert client.get(f"/api/v1/files/{name}").status_code == 404


@pytest.mark.parametrize(
    "path",
    ["/static/x/../../page.py", "/static/x/page.py", "/static/x/..%2f..%2fapi.py", "/static/lab.js",
     "/etc/passwd",
     "/static/x/%2e%2e%2f%2e%2e%2fapi.py", "/.git/config", "//etc/passwd", "/docs", "/redoc"],
)  # fmt: skip
def test_no_other_file_can_be_reached(client, path):
    assert client.get(path).status_code == 404


def test_the_page_names_its_assets_and_allows_no_others(client):
    got = client.get("/")
    assert got.status_code == 200
    assert "default-src 'self'" in got.headers["content-security-policy"]
    for line in got.text.splitlines():
        for quoted in line.split('"')[1::2]:
            if quoted.startswith("static/"):
                asset = client.get("/" + quoted)
                assert asset.status_code == 200
                assert "immutable" in asset.headers["cache-control"]
    assert client.get("/favicon.ico").status_code == 200


def test_health(client):
    assert client.get("/healthz").json() == {"status": "ok", "version": hh.__version__}
    # as those ask who watch over a server
    page = client.get("/").text
    tag = page.partition("static/")[2].partition("/")[0]
    for path in ("/healthz", "/", "/openapi.json", "/favicon.ico", f"/static/{tag}/lab.js", "/api/v1/files/motion.mp4"):
        reply = client.head(path)
        assert reply.status_code == 200, path
        assert reply.content == b""
    assert int(client.head("/", headers={"Accept-Encoding": "identity"}).headers["content-length"]) == len(page.encode())


def test_openapi_describes_every_route(client):
    document = client.get("/openapi.json").json()
    assert set(document["paths"]) == {
        "/api/v1/simulate", "/api/v1/theory", "/api/v1/map", "/api/v1/files/{name}", "/healthz",
    }  # fmt: skip
    for operations in document["paths"].values():
        for operation in operations.values():
            assert "200" in operation["responses"]
    text = json.dumps(document)
    for name in document["components"]["schemas"]:
        assert f"#/components/schemas/{name}" in text, name


def test_every_default_and_word_in_the_document_is_accepted(client):
    schemas = client.get("/openapi.json").json()["components"]["schemas"]
    axes = {
        "x": {"path": "start.speed", "from": 0.0, "to": 5.0},
        "y": {"path": "plane.mu", "from": 0.2, "to": 1.0},
    }

    def resolved(schema):
        (schema,) = schema.get("allOf", [schema])  # as pydantic before 2.9 has it
        return schemas[schema["$ref"].rpartition("/")[2]] if "$ref" in schema else schema

    request = schemas["MapRequest"]["properties"]
    offered = [request["what"]["default"], *request["what"].get("enum", [])]
    for axis in ("x", "y"):
        axes[axis]["cells"] = resolved(request[axis])["properties"]["cells"]["default"]
    for what in offered:
        reply = client.post("/api/v1/map", json={**axes, "what": what, "scenario": {"duration": 0.5}})
        assert reply.status_code == 200, (what, reply.text)
        axes["x"]["cells"] = axes["y"]["cells"] = 2
    names = client.get("/openapi.json").json()["paths"]["/api/v1/files/{name}"]["get"]["parameters"]
    for name in next(entry for entry in names if entry["name"] == "name")["schema"]["enum"]:
        if not name.endswith(("mp4", "gif")):
            assert client.get(f"/api/v1/files/{name}?duration=0.5").status_code == 200


def test_a_missing_extra_answers_501(monkeypatch, client):
    def missing(request, limits):
        need("hophoop_needs_this", "plots")

    call = calls.CALLS["theory"]
    monkeypatch.setitem(calls.CALLS, "theory", call._replace(answer=missing))
    application = routes.create_app(pool=Pool(USUAL, Here))
    reply = asking(application).post("/api/v1/theory", json={"duration": 3})
    assert reply.status_code == 501
    command = install_command("plots")
    sentence = f"hophoop_needs_this is not installed; it comes with the extra 'plots': {command}."
    assert reply.json() == {"detail": sentence, "extra": "plots", "install": command}
    with pytest.raises(MissingExtra) as raised:
        need("hophoop_needs_this", "plots")
    assert pickle.loads(pickle.dumps(raised.value)).extra == "plots"  # from the process that computes


@pytest.mark.parametrize("error", [ValueError("could not be broadcast"), TypeError("no"), ImportError("no such name")])
def test_a_defect_answers_500_and_is_logged(error, monkeypatch, client, caplog):
    def broken(request, limits):
        raise error

    call = calls.CALLS["theory"]
    monkeypatch.setitem(calls.CALLS, "theory", call._replace(answer=broken))
    application = routes.create_app(pool=Pool(USUAL, Here))
    asking = TestClient(application, base_url="http://localhost", raise_server_exceptions=False)
    reply = asking.post("/api/v1/theory", json={"duration": 3})
    assert reply.status_code == 500
    assert str(error) not in reply.text
    assert "in broken" in caplog.text
    assert f"{type(error).__name__}: {error}" in caplog.text


class Here:
    """Computes in this process."""

    active = True

    def __init__(self, count):
        pass

    def schedule(self, function, args, timeout):
        future = Future()
        try:
            future.set_result(function(*args))
        except Exception as error:
            future.set_exception(error)
        return future

    def stop(self):
        pass

    def join(self):
        pass


# The server


def test_serve_refuses_bad_addresses():
    with pytest.raises(InputError, match="port = 70000 must be from 0 to 65535"):
        app.serve(port=70000)
    with pytest.raises(InputError, match="workers = 0 must be from 1 to 256"):
        app.serve(workers=0)
    import socket

    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(InputError, match=r"cannot be used on 127\.0\.0\.1: .*in use"):
            app.serve(port=taken.getsockname()[1])


def test_serve_listens_on_loopback_unless_told_otherwise(monkeypatch):
    uvicorn = pytest.importorskip("uvicorn")
    seen = {}
    monkeypatch.setattr(uvicorn.Server, "run", lambda server: seen.update(vars(server.config)))
    app.serve(port=0, workers=3)
    assert seen["host"] == "127.0.0.1"
    assert seen["app"].state.limits.processes == 3
    assert seen["port"] > 0


def test_serve_to_a_network_prints_the_address_for_others(monkeypatch, capsys):
    uvicorn = pytest.importorskip("uvicorn")
    monkeypatch.setattr(uvicorn.Server, "run", lambda server: None)
    monkeypatch.setattr(app, "_own_address", lambda: "192.168.1.7")
    app.serve(host="0.0.0.0", port=0)
    assert re.search(r"Others in your network open http://192\.168\.1\.7:\d+/\.", capsys.readouterr().err)
    app.serve(port=0)
    assert "Others" not in capsys.readouterr().err


def test_a_machine_without_a_network_has_no_address(monkeypatch):
    def refuse(*_):
        raise OSError("Network is unreachable")

    with monkeypatch.context() as patched:
        patched.setattr("socket.socket.connect", refuse)
        assert app._own_address() is None
    assert app._own_address() is None or app._own_address().count(".") == 3


# Anything at all


@pytest.mark.long
def test_schemathesis_finds_nothing():
    schemathesis = pytest.importorskip("schemathesis", reason="schemathesis is not installed")
    from hypothesis import HealthCheck, Phase, given, settings

    # in this process, since hypothesis asks hundreds of times
    limits = replace(USUAL, duration=30.0, cells=400)
    application = routes.create_app(limits, names=["testserver"], pool=Pool(limits, Here))
    schema = schemathesis.openapi.from_asgi("/openapi.json", application)
    names = [
        "not_a_server_error",
        "status_code_conformance",
        "content_type_conformance",
        "response_schema_conformance",
    ]
    chosen = schemathesis.checks.CHECKS.get_by_names(names)
    covered = set()

    for result in schema.exclude(path_regex="files").get_all_operations():
        operation = result.ok()
        covered.add(operation.path)

        @settings(
            max_examples=25, deadline=None, database=None, phases=[Phase.generate],
            suppress_health_check=list(HealthCheck),
        )  # fmt: skip
        @given(case=operation.as_strategy())
        def run(case):
            case.call_and_validate(checks=chosen)

        run()
    assert covered == {"/api/v1/simulate", "/api/v1/theory", "/api/v1/map", "/healthz"}
