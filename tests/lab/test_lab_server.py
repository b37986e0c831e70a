"""The lab as a server: who may ask, what is sent, files of a motion, and how it ends."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from urllib.parse import urlsplit

import pytest

pytest.importorskip("starlette", reason="the extra 'lab' is not installed")
pytest.importorskip("httpx", reason="httpx is not installed")
uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")
from starlette.testclient import TestClient  # noqa: E402

import hophoop as hh  # noqa: E402
from hophoop.lab.api.limits import within  # noqa: E402
from hophoop.lab.server import app, site  # noqa: E402
from hophoop.lab.wasm.stamp import built  # noqa: E402
from hophoop.scenario import InputError  # noqa: E402
from lab_page_tools import serving  # noqa: E402

SLOW = {"duration": 600, "contact": {"model": "compliant", "stiffness": 1e9}, "start": {"speed": 3.1}}


@pytest.fixture(scope="module")
def client():
    with TestClient(site.create_app(names=["hoop.example.org"]), base_url="http://localhost") as client:
        yield client


# Who may ask


def test_its_own_names_are_answered_and_foreign_ones_refused(client):
    for host in ("localhost:8765", "127.0.0.1", "[::1]:8765", "192.168.1.7:80", "hoop.example.org", "a.localhost"):
        assert client.get("/", headers={"Host": host}).status_code == 200, host
    for host in ("evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example", "", "localhost:b:c"):
        reply = client.get("/", headers={"Host": host})
        assert reply.status_code == 403, host
        assert "is not a name of this lab" in reply.json()["detail"]
        assert "content-security-policy" in reply.headers


def test_a_form_of_another_site_may_not_ask(client):
    for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", ""):
        reply = client.post("/files/motion.nc", content=b"{}", headers={"Content-Type": kind})
        assert reply.status_code == 415
        assert "must be application/json" in reply.json()["detail"]
    # a script of another site has to ask first, and is not answered
    asked = client.options("/files/motion.nc", headers={"Origin": "http://evil.example"})
    assert asked.status_code == 405
    assert "access-control-allow-origin" not in asked.headers


# The page


def test_the_page_names_its_files_and_allows_no_others(client):
    page = client.get("/")
    assert page.headers["cache-control"] == "no-cache"
    for name in re.findall(r'(?:href|src)="(static/[^"]+)"', page.text):
        assert re.match(r"static/[0-9a-f]{16}/", name)
        reply = client.get(f"/{name}")
        assert reply.status_code == 200
        assert "immutable" in reply.headers["cache-control"]
    # the module comes along with the script that asks for it
    (asked,) = re.findall(r'rel="preload" href="static/[0-9a-f]{16}/hophoop\.wasm\?(\w+)"', page.text)
    assert asked == built()["module"]
    assert not re.search("service-worker|manifest|http-equiv|http.server", page.text)  # of an exported folder
    assert client.get("/static/x/hophoop.wasm").headers["content-type"] == "application/wasm"
    assert client.get("/favicon.ico").headers["content-type"] == "image/svg+xml"


def test_no_other_file_can_be_reached(client):
    for path in ("x/../../app.py", "x/index.html", "x/%2e%2e%2ftables.py", "x/"):
        assert client.get(f"/static/{path}").status_code == 404, path


def test_text_is_compressed_for_those_who_take_it(client):
    assert client.get("/static/x/lab.js", headers={"Accept-Encoding": "gzip"}).headers["content-encoding"] == "gzip"


# Files of a motion


def test_a_file_is_made(client, tmp_path):
    reply = client.post("/files/motion.nc", json={"start": {"speed": 2.8}, "plane": {"mu": "inf"}, "duration": 2})
    assert reply.status_code == 200
    assert reply.headers["content-disposition"] == 'attachment; filename="hophoop-motion.nc"'
    (tmp_path / "motion.nc").write_bytes(reply.content)
    motion = hh.load(tmp_path / "motion.nc")
    assert motion.scenario == within(hh.Scenario.from_query("start.speed=2.8&plane.mu=inf&duration=2"))


@pytest.mark.parametrize(
    ("name", "body", "status", "said"),
    [
        ("motion.nc", b'{"plane": {"mu": "high"}}', 422, "plane.mu = 'high' must be a number."),
        ("motion.nc", b'{"hoop": "\xff"}', 422, ""),
        ("motion.nc", b'{"duration": 601}', 413, "duration = 601 must be at most 600 s"),
        ("motion.exe", b"{}", 404, "The file must be one of motion.nc, motion.mp4, motion.gif."),
        ("motion.nc", b" " * 70_000, 413, "The body has more than 65536 bytes."),
    ],
)
def test_bad_input_is_refused_in_one_sentence(client, name, body, status, said):
    reply = client.post(f"/files/{name}", content=body, headers={"Content-Type": "application/json"})
    assert reply.status_code == status
    detail = reply.json()["detail"]
    assert said in detail
    assert "\n" not in detail
    assert detail.endswith((".", "?"))


def test_a_missing_extra_is_said_with_its_command(client, monkeypatch, tmp_path):
    missing = "raise ModuleNotFoundError(\"No module named 'xarray'\", name='xarray')"
    (tmp_path / "xarray.py").write_text(missing, encoding="utf-8")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    reply = client.post("/files/motion.nc", json={"duration": 0.5})
    assert reply.status_code == 501
    said = reply.json()
    assert said["extra"] == "maps"
    assert "pip install" in said["install"]


def test_what_takes_too_long_is_ended(client, monkeypatch):
    monkeypatch.setattr(site, "PATIENCE", 0.5)
    begin = time.monotonic()
    reply = client.post("/files/motion.nc", json=SLOW)
    assert reply.status_code == 413
    assert reply.json() == {"detail": "The file takes longer than 0.5 s."}
    assert time.monotonic() - begin < 20


def test_a_defect_is_said_and_logged(client, monkeypatch, caplog):
    monkeypatch.setattr(site, "MAKER", (sys.executable, "-c", "1 / 0"))
    reply = client.post("/files/motion.nc", json={})
    assert reply.status_code == 500
    assert reply.json() == {"detail": "The computation failed."}
    assert "ZeroDivisionError" in caplog.text


# All of it


@pytest.fixture
def address():
    with serving() as address:
        yield "127.0.0.1", urlsplit(address).port


def asked(address):
    """A line on which a file was asked for that takes long."""
    body = json.dumps(SLOW).encode()
    line = socket.create_connection(address, 60)
    line.sendall(HEAD + b"Content-Length: %d\r\n\r\n" % len(body) + body)
    return line


HEAD = b"POST /files/motion.nc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"


def test_slow_and_many_clients_wait_or_are_refused_and_others_are_answered(address, monkeypatch):
    monkeypatch.setattr(site, "PATIENCE", 3.0)
    monkeypatch.setattr(site, "READING", 1.0)
    lines = [asked(address) for _ in range(site.WAITING + 6)]
    half = socket.create_connection(address, 60)
    half.sendall(HEAD + b"Content-Length: 100\r\n\r\n{")
    assert b"408" in half.recv(100)
    # the page is answered meanwhile
    begin = time.monotonic()
    page = socket.create_connection(address, 60)
    page.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
    assert b"200 OK" in page.recv(100)
    assert time.monotonic() - begin < 2.0
    assert any(b" 503 " in line.recv(100) for line in lines[-4:])
    for line in (*lines, half, page):
        line.close()


@pytest.mark.skipif(os.name != "posix", reason="only POSIX has interrupts of one process")
@pytest.mark.slow
def test_it_stops_at_once_and_says_nothing_of_those_who_went_away():
    command = [sys.executable, "-m", "hophoop", "lab", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        port = re.search(r"is at http://127.0.0.1:(\d+)/", process.stderr.readline() + process.stderr.readline())[1]
        lines = [asked(("127.0.0.1", int(port))) for _ in range(6)]
        time.sleep(1.0)
        for line in lines[:4]:
            line.close()
        time.sleep(0.5)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        assert time.monotonic() - begin < 6.0
        assert "Traceback" not in said, said
        assert "ERROR" not in said, said
        assert process.returncode == 0


def test_serve_refuses_bad_addresses():
    with pytest.raises(InputError, match="port = 70000 must be from 0 to 65535"):
        app.serve(port=70000)
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(InputError, match=r"cannot be used on 127\.0\.0\.1: .*in use"):
            app.serve(port=taken.getsockname()[1])


def test_serve_listens_on_loopback_unless_told_otherwise(monkeypatch, capsys):
    seen = []

    def run(server, lines):
        seen.extend(line.getsockname() for line in lines)
        lines[0].close()

    monkeypatch.setattr(uvicorn.Server, "run", run)
    monkeypatch.setattr(app, "_own_address", lambda: "192.168.1.7")
    app.serve(port=0)
    ((host, port),) = seen
    assert host == "127.0.0.1"
    assert port > 0
    assert "Others" not in capsys.readouterr().err
    app.serve(host="0.0.0.0", port=0)
    assert re.search(r"Others in your network open http://192\.168\.1\.7:\d+/\.", capsys.readouterr().err)
