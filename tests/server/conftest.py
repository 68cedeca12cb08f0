"""Starts the real server on a folder of its own, and speaks HTTP with it. Every answer is held against openapi.json."""

import http.client
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import time
import urllib.parse

import jsonschema
import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = pathlib.Path(os.environ.get("SPECTRALPACK_BUILD", ROOT / "build"))
PROGRAM = BUILD / "apps" / "cli" / "spectralpack"
SAMPLES = ROOT / "data" / "samples"
API = json.loads((ROOT / "apps" / "server" / "openapi.json").read_text())


def resolved(node):
    """The node that a $ref in it stands for."""
    while "$ref" in node:
        where = API
        for key in node["$ref"].removeprefix("#/").split("/"):
            where = where[key]
        node = where
    return node


def operation_of(method, path):
    for pattern, operations in API["paths"].items():
        if re.fullmatch(re.sub(r"\{\w+\}", "[^/]+", pattern.replace(".", r"\.")), path) and method.lower() in operations:
            return operations[method.lower()]
    return None


def require_described(method, path, status, content_type, body):
    """The answer is one that openapi.json knows."""
    operation = operation_of(method, path)
    if operation is None:
        assert status in (403, 404, 405), f"{method} {path} is answered with {status}, and openapi.json does not know it"
        return
    answers = operation["responses"]
    if status in (400, 408, 431, 500) and str(status) not in answers:
        return  # of no address in particular
    assert str(status) in answers, f"{method} {path}: {status} is not described"
    content = resolved(answers[str(status)]).get("content", {})
    kind = content_type.split(";")[0]
    if not content:
        assert body == b""
        return
    assert kind in content, f"{method} {path}: {kind} is not described"
    if kind == "application/json":
        schema = {"$ref": "#/$defs/it", "$defs": {"it": content[kind]["schema"]}, "components": API["components"]}
        jsonschema.Draft202012Validator(schema).validate(json.loads(body))


class Answer:
    def __init__(self, status, headers, body):
        self.status, self.headers, self.body = status, headers, body

    @property
    def json(self):
        return json.loads(self.body)


class Server:
    def __init__(self, folder, *options, command=("serve",), environment=None):
        self.folder, self.options, self.command = folder, options, command
        self.environment = {**os.environ, **(environment or {})}
        self.process = None
        self.port = None
        self.start()

    def start(self):
        if self.port is None:
            with socket.socket() as probe:
                probe.bind(("127.0.0.1", 0))
                self.port = probe.getsockname()[1]
        self.process = subprocess.Popen(
            [PROGRAM, *self.command, "--dir", self.folder, "--port", str(self.port), "--no-browser", *self.options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.environment)
        self.said = self.process.stdout.readline()
        if not self.said:
            raise RuntimeError(self.process.communicate()[1])

    def stop(self, how=signal.SIGINT):
        self.process.send_signal(how)
        self.process.wait(20)
        self.process.stdout.close()
        self.process.stderr.close()

    def ask(self, method, path, body=None, headers=None, host=None, described=True):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        if isinstance(body, (dict, list)):
            body = json.dumps(body).encode()
        sent = {"Host": host or f"127.0.0.1:{self.port}", **(headers or {})}
        connection.request(method, path, body, sent)
        response = connection.getresponse()
        answer = Answer(response.status, dict(response.getheaders()), response.read())
        connection.close()
        if described:
            plain = urllib.parse.urlparse(path).path
            require_described(method, plain, answer.status, answer.headers.get("Content-Type", ""), answer.body)
        return answer

    def get(self, path, **more):
        return self.ask("GET", path, **more)

    def new_job(self, **said):
        answer = self.ask("POST", "/api/jobs", said)
        assert answer.status == 201, answer.body
        return answer.json["id"]

    def put_file(self, job, name, data, **more):
        return self.ask("PUT", f"/api/jobs/{job}/files/{urllib.parse.quote(name, safe='')}", data, **more)

    def parts(self, job, seconds=60):
        """What the files hold, once all are read."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            parts = self.get(f"/api/jobs/{job}/parts").json
            if parts["reading"] == 0:
                return parts
            time.sleep(0.05)
        raise TimeoutError("files are still being read")

    def wait(self, job, *statuses, seconds=120):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            state = self.get(f"/api/jobs/{job}").json
            if state["status"] in (statuses or ("done", "cancelled", "failed", "interrupted")):
                return state
            time.sleep(0.05)
        raise TimeoutError(f"the job is {state['status']}")


@pytest.fixture
def server(tmp_path):
    running = Server(tmp_path / "jobs")
    yield running
    running.stop()


@pytest.fixture
def start_server(tmp_path):
    started = []

    def start(*options, folder="jobs", **more):
        started.append(Server(tmp_path / folder, *options, **more))
        return started[-1]

    yield start
    for one in started:
        if one.process.poll() is None:
            one.stop()


def sample_job(server, voxel=2, tray=(160, 120, 100), **options):
    """A job with a few of the sample parts, ready to be started."""
    job = server.new_job(name="a few parts")
    for name in ("bracket.stl", "gear.stl", "hook.stl"):
        assert server.put_file(job, name, (SAMPLES / name).read_bytes()).status == 201
    said = {"format": "spectralpack/job", "version": 1, "container": {"size": list(tray)}, "gap": 1,
            "parts": [{"mesh": "bracket.stl", "count": 4}, {"mesh": "gear.stl", "count": 6}, {"mesh": "hook.stl", "count": 5}],
            "options": {"voxel": voxel, **options}}
    assert server.ask("PUT", f"/api/jobs/{job}/job.json", said).status == 204
    return job


def long_job(server, copies=400):
    """One that takes a while."""
    return_job = server.new_job(name="many parts")
    for name in ("bracket.stl", "gear.stl", "hook.stl", "mug.stl"):
        assert server.put_file(return_job, name, (SAMPLES / name).read_bytes()).status == 201
    said = {"format": "spectralpack/job", "version": 1, "container": {"size": [400, 300, 300]}, "gap": 1,
            "parts": [{"mesh": name, "count": copies} for name in ("bracket.stl", "gear.stl", "hook.stl", "mug.stl")],
            "options": {"voxel": 1}}
    assert server.ask("PUT", f"/api/jobs/{return_job}/job.json", said).status == 204
    return return_job
