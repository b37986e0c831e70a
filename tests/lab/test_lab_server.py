"""The lab as a server: what is refused before it begins, who may ask, what is sent, and how connections end."""

import contextlib
import gzip
import json
import signal
import socket
import subprocess
import sys
import threading
import time
from dataclasses import replace

import pytest

pytest.importorskip("fastapi", reason="the extra 'lab' is not installed")
pytest.importorskip("httpx", reason="httpx is not installed")
uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")
from fastapi.testclient import TestClient  # noqa: E402

import hophoop as hh  # noqa: E402
from hophoop.lab.api.limits import USUAL, turns_of  # noqa: E402
from hophoop.lab.server import connections, routes  # noqa: E402
from hophoop.lab.server.guard import host_name  # noqa: E402
from hophoop.scenario import Scenario, Start  # noqa: E402
from lab_tools import POSIX  # noqa: E402

# What is refused before it begins


@pytest.fixture(scope="module")
def client():
    limits = replace(USUAL, patience=300.0, queue=300.0)  # others may be at work on this machine
    with TestClient(routes.create_app(limits, names=["hoop.example.org"]), base_url="http://localhost") as client:
        yield client


@pytest.mark.parametrize("changed", [{"start": {"speed": 1e6}}, {"hoop": {"radius": 1e-6}, "start": {"speed": 3.0}}])
def test_a_motion_of_too_many_revolutions_is_refused_at_once(client, changed):
    begin = time.monotonic()
    reply = client.post("/api/v1/simulate", json={"duration": 6.0, **changed})
    assert reply.status_code == 413
    assert "revolutions and must be at most" in reply.json()["detail"]
    assert time.monotonic() - begin < 15.0  # on a machine with much else to do


@pytest.mark.parametrize(
    ("x", "what"),
    [
        ({"path": "start.speed", "from": 0.0, "to": 1e6}, "end_angle"),
        ({"path": "duration", "from": 1.0, "to": 1e9}, "end_angle"),
        ({"path": "hoop.radius", "from": 1e-6, "to": 2e-6}, "energy_lost"),
        ({"path": "start.omega", "from": 0.0, "to": 1e9}, "ending"),
    ],
)
def test_a_map_of_too_many_revolutions_is_refused_and_the_next_one_is_computed(client, x, what):
    y = {"path": "plane.mu", "from": 0.2, "to": 1.0, "cells": 8}
    scenario = {"start": {"omega": 1.0}} if x["path"] == "start.omega" else {"start": {"speed": 3.0}}
    reply = client.post("/api/v1/map", json={"x": {**x, "cells": 200}, "y": y, "what": what, "scenario": scenario})
    assert reply.status_code == 413
    assert "revolutions" in reply.json()["detail"]
    small = {"x": {"path": "start.speed", "from": 0.0, "to": 5.0, "cells": 4}, "y": y}
    assert client.post("/api/v1/map", json=small).status_code == 200


def test_cells_that_no_scenario_may_have_are_blank(client):
    y = {"path": "plane.mu", "from": -0.5, "to": 0.5, "cells": 4}
    x = {"path": "start.speed", "from": 0.0, "to": 4.0, "cells": 3}
    values = client.post("/api/v1/map", json={"x": x, "y": y}).json()["values"]
    assert [[value is None for value in row] for row in values] == [[True] * 3] * 2 + [[False] * 3] * 2
    nothing = client.post("/api/v1/map", json={"x": x, "y": {**y, "to": -0.1}}).json()
    assert nothing["classes"] == []
    assert all(value is None for row in nothing["values"] for value in row)


def test_the_estimate_of_revolutions_is_from_above_and_not_far():
    for scenario in (
        Scenario(),
        Scenario(start=Start.rolling(2.0), duration=60.0),
        Scenario(start=Start(angle=0.5, vx=8.0, omega=20.0, height=0.5), duration=10.0),
        Scenario(plane=hh.Plane(slope=0.2), start=Start.rolling(1.0), duration=5.0),
        Scenario(hoop=hh.Hoop(radius=0.05), start=Start.rolling(1.0), duration=5.0),
    ):
        motion = hh.simulate(scenario)
        angles = motion.at(motion.times(2001)).angle
        turned = float(abs(angles[1:] - angles[:-1]).sum()) / 6.283185307179586
        assert turned <= turns_of(scenario) <= 15.0 * turned + 5.0


def test_a_busy_lab_says_when_to_ask_again():
    application = routes.create_app(replace(USUAL, queue=-1.0))
    reply = TestClient(application, base_url="http://localhost").post("/api/v1/simulate", json={})
    assert reply.status_code == 503
    assert int(reply.headers["retry-after"]) >= 1
    assert "busy" in reply.json()["detail"]


# Who may ask


@pytest.mark.parametrize(
    "host", ["localhost:8765", "127.0.0.1", "[::1]:8765", "192.168.1.7:80", "hoop.example.org", "a.localhost"]
)
def test_its_own_names_are_answered(client, host):
    assert client.get("/healthz", headers={"Host": host}).status_code == 200


@pytest.mark.parametrize(
    "host", ["evil.example", "evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example", "", "a:b:c"]
)
def test_foreign_names_are_refused(client, host):
    reply = client.get("/", headers={"Host": host})
    assert reply.status_code == 403
    assert "is not a name of this lab" in reply.json()["detail"]
    assert "content-security-policy" in reply.headers


def test_host_names_are_read_without_their_port():
    assert [host_name(text) for text in ("A.b:80", "[::1]:80", "[::1]", "x")] == ["a.b", "::1", "::1", "x"]


@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({}, 200),
        ({"Origin": "http://localhost"}, 200),
        ({"Origin": "https://localhost"}, 200),  # a proxy in front adds TLS
        ({"Origin": "http://localhost:3000"}, 403),
        ({"Origin": "http://evil.example"}, 403),
        ({"Origin": "null"}, 403),
        ({"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "no-cors"}, 403),
        ({"Sec-Fetch-Site": "same-origin", "Sec-Fetch-Mode": "cors"}, 200),
    ],
)
def test_other_pages_may_not_ask(client, headers, status):
    assert client.post("/api/v1/theory", json={}, headers=headers).status_code == status


def test_a_link_elsewhere_leads_to_the_page(client):
    assert client.get("/", headers={"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "navigate"}).status_code == 200


# What is sent


def test_text_is_compressed_for_those_who_take_it(client):
    path = "/static/x/lab.js"
    plain = client.get(path, headers={"Accept-Encoding": "identity"})
    with client.stream("GET", path, headers={"Accept-Encoding": "gzip"}) as reply:
        raw = b"".join(reply.iter_raw())
        assert reply.headers["content-encoding"] == "gzip"
        assert "Accept-Encoding" in reply.headers["vary"]
    assert gzip.decompress(raw) == plain.content
    assert len(raw) < 0.4 * len(plain.content)
    assert client.get(path, headers={"Accept-Encoding": "gzip;q=0"}).headers.get("content-encoding") is None
    answer = client.post("/api/v1/simulate?samples=50", json={})
    assert answer.headers["content-encoding"] == "gzip"
    assert answer.headers["etag"].startswith('W/"')
    again = client.post("/api/v1/simulate?samples=50", json={}, headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304


# Connections


@pytest.fixture
def address(monkeypatch):
    monkeypatch.setattr(connections, "SECONDS", 0.4)

    async def application(scope, receive, send):
        await send({"type": "http.response.start", "status": 200, "headers": [(b"content-length", b"2")]})
        await send({"type": "http.response.body", "body": b"ok"})

    with served(application, lifespan="off") as address:
        yield address


HEAD = b"POST /api/v1/simulate HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"


@contextlib.contextmanager
def served(application, **options):
    config = uvicorn.Config(
        application, port=0, http=connections.Connection, log_level="critical", h11_max_incomplete_event_size=32768, **options
    )
    server = connections.Server(config)
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    end = time.monotonic() + 30
    while not server.started and time.monotonic() < end:
        time.sleep(0.01)
    yield server.servers[0].sockets[0].getsockname()
    server.should_exit = True
    thread.join(5)


@pytest.mark.parametrize("said", [b"", b"GET / HT", b"GET / HTTP/1.1\r\nHost: x\r\n"])
@pytest.mark.parametrize("before", [False, True])
def test_a_half_open_connection_is_closed(address, said, before):
    with socket.create_connection(address, 20) as line:
        if before:
            if not said:
                return  # between two requests uvicorn's own limit counts
            line.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
            assert line.recv(1000).startswith(b"HTTP/1.1 200")
        line.sendall(said)
        while line.recv(1000):
            pass  # closed by the server, or the test's own limit ends it


def test_a_slow_request_is_answered_within_the_time(address):
    with socket.create_connection(address, 20) as line:
        for piece in (b"GET / HTTP/1.1\r\n", b"Host: x\r\n", b"\r\n"):
            line.sendall(piece)
            time.sleep(0.05)
        assert line.recv(1000).startswith(b"HTTP/1.1 200")
        time.sleep(0.6)  # longer than a head may take, but the request is complete
        line.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        assert line.recv(1000).startswith(b"HTTP/1.1 200")


def test_a_body_that_drips_ends_the_connection():
    """After the answer it went on for as long as bytes came."""
    limits = replace(USUAL, reading=0.4)
    with served(routes.create_app(limits)) as address, socket.create_connection(address, 20) as line:
        line.sendall(HEAD + b"Content-Length: 1000\r\n\r\n{")
        said = b""
        end = time.monotonic() + 20.0
        line.settimeout(0.05)
        while time.monotonic() < end:
            try:
                piece = line.recv(10_000)
                if not piece:
                    break
                said += piece
            except TimeoutError:
                pass
            except ConnectionError:
                break
            try:
                line.sendall(b" ")
            except ConnectionError:
                break
        else:
            pytest.fail("the connection stays")
    assert said.startswith(b"HTTP/1.1 408")
    assert b"connection: close" in said.lower()
    assert b"did not arrive" in said


@pytest.mark.parametrize(
    ("head", "status", "sentence"),
    [
        (b"GET /?" + b"a" * 40_000, 414, "The address of this request is too long"),
        (b"GET / HTTP/1.1\r\nHost: x\r\nX-Long: " + b"a" * 40_000, 431, "The headers of this request"),
        (b"SOMETHING ELSE\r\n\r\n", 400, "Invalid HTTP request received."),
    ],
)
def test_a_head_that_is_too_long_is_refused_in_a_sentence(address, head, status, sentence):
    with socket.create_connection(address, 20) as line:
        line.sendall(head)
        said = b""
        with contextlib.suppress(ConnectionError):
            while piece := line.recv(10_000):
                said += piece
    answer, _, body = said.partition(b"\r\n\r\n")
    assert answer.startswith(b"HTTP/1.1 %d" % status)
    assert sentence in (json.loads(body)["detail"] if status != 400 else body.decode())


def test_a_long_address_is_refused_in_a_sentence(client):
    for path in ("/", "/api/v1/files/motion.csv", "/healthz"):
        reply = client.get(path, params={"plane.mu": "1" * 17_000})
        assert reply.status_code == 414
        assert "send the scenario in the body" in reply.json()["detail"]


# All of it


@POSIX
@pytest.mark.slow
def test_it_stops_at_once_and_says_nothing_of_those_who_went_away(tmp_path):
    free = socket.socket()
    free.bind(("127.0.0.1", 0))
    port = free.getsockname()[1]
    free.close()
    # a file, not a pipe: what compiles beside goes on after the server and keeps it open
    told = (tmp_path / "said").open("w+")
    process = subprocess.Popen([sys.executable, "-m", "hophoop", "lab", "--no-browser", "--port", str(port)], stderr=told)
    try:
        _until_open(port)
        body = b'{"duration": 600, "contact": {"model": "compliant", "stiffness": 1e5}, "start": {"speed": 3.1}}'
        lines = []
        for _ in range(6):
            line = socket.create_connection(("127.0.0.1", port), 20)
            line.sendall(HEAD + b"Content-Length: %d\r\n\r\n" % len(body) + body)
            lines.append(line)
        half = socket.create_connection(("127.0.0.1", port), 20)
        half.sendall(HEAD + b"Content-Length: 100\r\n\r\n{")
        time.sleep(1.0)
        for line in (*lines[:4], half):
            line.close()
        time.sleep(0.5)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)
        assert time.monotonic() - begin < 6.0  # under a second where nothing else is at work
        told.seek(0)
        said = told.read()
        assert "Traceback" not in said, said
        assert "ERROR" not in said, said
        assert process.returncode == 0
    finally:
        process.kill()
        process.wait()
        told.close()


def _until_open(port):
    end = time.monotonic() + 120
    while time.monotonic() < end:
        try:
            socket.create_connection(("127.0.0.1", port), 1).close()
            return
        except OSError:
            time.sleep(0.1)
    raise AssertionError("the server did not start")
