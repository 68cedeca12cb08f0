"""What the server does not do, each with its words: who asks, what is named, how much is sent."""

import http.client
import json
import os
import socket
import time

import pytest

from conftest import SAMPLES, sample_job


def refused(answer, status, *words):
    assert answer.status == status, (answer.status, answer.body)
    for word in words:
        assert word in answer.json["error"], answer.json


# Who asks.


@pytest.mark.parametrize("host", ["evil.example", "evil.example:80", "127.0.0.1:1", "localhost.evil.example", ""])
def test_another_name_for_this_machine(server, host):
    refused(server.ask("GET", "/api/jobs", host=host or "x"), 403, "name")


def test_localhost_is_this_machine(server):
    assert server.ask("GET", "/api/jobs", host=f"localhost:{server.port}").status == 200


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://127.0.0.1"])
def test_another_sites_page(server, origin):
    refused(server.ask("POST", "/api/jobs", {}, headers={"Origin": origin}), 403, "another site")


def test_another_sites_picture_of_ours(server):
    refused(server.ask("GET", "/api/jobs", headers={"Sec-Fetch-Site": "cross-site"}), 403)
    refused(server.ask("GET", "/api/jobs", headers={"Sec-Fetch-Site": "same-site"}), 403)
    assert server.ask("GET", "/api/jobs", headers={"Sec-Fetch-Site": "same-origin"}).status == 200
    # A link leads to the page itself.
    assert server.ask("GET", "/", headers={"Sec-Fetch-Site": "cross-site"}, described=False).status == 200


def test_our_own_page(server):
    own = {"Origin": f"http://127.0.0.1:{server.port}"}
    assert server.ask("POST", "/api/jobs", {}, headers=own).status == 201


def test_the_token(start_server):
    server = start_server("--listen", "0.0.0.0")
    token = server.said.split("#token=")[1].split()[0]
    assert len(token) >= 32
    refused(server.get("/api/jobs"), 401, "token")
    refused(server.ask("GET", "/api/jobs", headers={"Authorization": "Bearer " + token[:-1]}), 401)
    refused(server.ask("GET", "/api/jobs", headers={"Authorization": "Bearer " + token + "x"}), 401)
    assert server.ask("GET", "/api/jobs", headers={"Authorization": "Bearer " + token}).status == 200
    assert server.get("/", described=False).status == 200  # the page asks for it
    refused(server.ask("POST", "/api/session", {"token": "wrong"}), 401)
    cookie = server.ask("POST", "/api/session", {"token": token}).headers["Set-Cookie"]
    assert "HttpOnly" in cookie and "SameSite=Strict" in cookie
    assert server.ask("GET", "/api/jobs", headers={"Cookie": "a=b; " + cookie.split(";")[0]}).status == 200
    # Children, whose surroundings others may read, do not know it.
    command = f"/proc/{server.process.pid}/cmdline"
    assert token.encode() not in open(command, "rb").read()


def test_on_this_machine_alone_no_token_is_needed_but_one_may_be_said(start_server):
    server = start_server(environment={"SPECTRALPACK_TOKEN": "of-our-own"})
    refused(server.get("/api/jobs"), 401)
    assert server.ask("GET", "/api/jobs", headers={"Authorization": "Bearer of-our-own"}).status == 200


# What is named.


@pytest.mark.parametrize("name, why", [("../../etc/passwd", "dot"), ("..", "dot"), (".hidden.stl", "dot"), ("a/b.stl", "folders"),
                                       ("a\\b.stl", "folders"), ("a\nb.stl", "control"), ("x" * 201 + ".stl", "200")])
def test_names_that_are_no_names(server, name, why):
    refused(server.put_file(server.new_job(), name, b"solid x"), 400, why)


@pytest.mark.parametrize("path", ["/api/jobs/%2e%2e/files/a.stl", "/api/jobs/../../etc", "/api//jobs", "/%zz", "/../etc/passwd",
                                  "/assets/../index.html", "/api/jobs/zzzzzzzzzzzz", "/api/none", "/etc/passwd"])
def test_addresses_that_lead_nowhere(server, path):
    answer = server.get(path, described=False)
    assert answer.status in (400, 404) and answer.json["error"]


def test_names_that_are_not_utf8(server):
    answer = server.ask("PUT", f"/api/jobs/{server.new_job()}/files/a%ff.stl", b"solid x")
    refused(answer, 400, "UTF-8")


@pytest.mark.parametrize("said, key", [
    ({"parts": [{"mesh": "/etc/passwd", "count": 1}]}, "parts[0].mesh"),
    ({"parts": [{"mesh": "../x.stl", "count": 1}]}, "parts[0].mesh"),
    ({"parts": [{"mesh": "not-sent.stl", "count": 1}]}, "not-sent.stl"),
    ({"parts": [], "container": {"mesh": "/etc/hosts"}}, "container.mesh"),
    ({"parts": [], "keep_out": [{"mesh": "../../x"}]}, "keep_out[0].mesh"),
    ({"parts": [], "fixed": [{"mesh": "../../x"}]}, "fixed[0].mesh"),
    ({"parts": [], "onto": "/tmp/b.json"}, "onto"),
    ({"parts": [], "keep": "/tmp/b.json"}, "keep"),
    ({"parts": [], "options": {"output": ["/tmp/x.3mf"]}}, "options.output"),
    ({"parts": [], "options": {"report": ["/tmp/x.html"]}}, "options.report"),
    ({"parts": [], "options": {"journal": "/tmp/j"}}, "options.journal"),
    ({"parts": [], "options": {"mesh-dir": "/"}}, "options.mesh-dir"),
    ({"parts": [], "options": {"container": "/etc/hosts"}}, "options.container"),
    ({"parts": [], "options": {"keep-out": ["/etc/hosts"]}}, "options.keep-out"),
    ({"parts": [], "options": {"threads": 64}}, "options.threads"),
    ({"parts": [], "options": {"memory": 10**15}}, "options.memory"),
    ([], "object"),
])
def test_job_files_that_reach_beyond_their_job(server, said, key):
    refused(server.ask("PUT", f"/api/jobs/{server.new_job()}/job.json", said), 400, key)


def test_a_file_that_became_a_link_is_not_followed(server):
    job = sample_job(server)
    server.parts(job)
    file = server.folder / job / "files" / "gear.stl"
    file.unlink()
    file.symlink_to("/etc/hostname")
    refused(server.get(f"/api/jobs/{job}/files/gear.stl"), 409, "gear.stl")
    refused(server.ask("POST", f"/api/jobs/{job}/start"), 409, "gear.stl")


def test_nonsense(server):
    job = server.new_job()
    refused(server.ask("PUT", f"/api/jobs/{job}/job.json", b"{"), 400, "JSON")
    refused(server.ask("POST", "/api/jobs", b"[1"), 400, "JSON")
    refused(server.ask("POST", "/api/jobs", {"name": "x" * 101}), 400, "100")
    refused(server.ask("POST", "/api/jobs", {"name": "a\u0007b"}), 400, "control")
    refused(server.ask("POST", "/api/jobs", {"copy_of": "zzzzzzzzzzzz"}), 404)
    refused(server.ask("POST", f"/api/jobs/{job}/start"), 409, "job file")
    refused(server.ask("POST", f"/api/jobs/{job}/cancel"), 409)
    refused(server.get(f"/api/jobs/{job}/packing.json"), 404)
    refused(server.get("/api/jobs?most=-1"), 400, "most")
    # What only packing finds wrong, it says.
    server.put_file(job, "gear.stl", (SAMPLES / "gear.stl").read_bytes())
    said = {"format": "spectralpack/job", "version": 1, "parts": [{"mesh": "gear.stl", "count": 1, "colour": "red"}]}
    server.ask("PUT", f"/api/jobs/{job}/job.json", said)
    refused(server.ask("POST", f"/api/jobs/{job}/estimate"), 400, "colour")
    server.ask("POST", f"/api/jobs/{job}/start")
    state = server.wait(job)
    assert state["status"] == "failed" and "colour" in state["error"]


# How much is sent.


def chunked(server, path, chunks):
    """As a chunked body; the answer, or None where the connection ended without one."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=60)
    try:
        connection.request("PUT", path, iter(chunks), {"Transfer-Encoding": "chunked"}, encode_chunked=True)
        response = connection.getresponse()
        return response.status, json.loads(response.read())
    except (BrokenPipeError, ConnectionResetError):
        return None
    finally:
        connection.close()


def bytes_in(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def test_files_that_are_too_large(start_server):
    server = start_server("--file-size", "1M")
    job = server.new_job()
    refused(server.put_file(job, "large.stl", b"\0" * 1_000_001), 413, "large.stl", "1 MB")
    assert server.put_file(job, "fits.stl", b"\0" * 1_000_000).status == 201
    # Announced or not: what is beyond the limit is not kept.
    answer = chunked(server, f"/api/jobs/{job}/files/chunked.stl", (b"\0" * 100_000 for _ in range(3000)))
    assert answer is None or (answer[0] == 413 and "chunked.stl" in answer[1]["error"])
    assert bytes_in(server.folder) < 3_000_000
    assert server.get(f"/api/jobs/{job}").json["files"] == 1
    assert chunked(server, f"/api/jobs/{job}/files/small.stl", [b"\0" * 1000])[0] == 201


def test_job_files_that_are_too_large(server):
    job = server.new_job()
    answer = server.ask("PUT", f"/api/jobs/{job}/job.json", b'{"x": "' + b"y" * 17_000_000 + b'"}')
    refused(answer, 413)


def test_heads_that_are_too_long(server):
    with socket.create_connection(("127.0.0.1", server.port)) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: " + b"y" * 100_000)
        assert b" 431 " in connection.recv(4096)


def test_a_bomb_of_an_archive(server):
    """A 3MF that unpacks to much more than it is: refused in words, and the server lives."""
    import io
    import zipfile
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        archive.writestr("_rels/.rels", "<Relationships/>")
        with archive.open("3D/3dmodel.model", "w") as model:
            for _ in range(1500):
                model.write(b" " * 1_000_000)
    job = server.new_job()
    assert server.put_file(job, "bomb.3mf", packed.getvalue()).status == 201
    parts = server.parts(job)
    assert [bad["file"] for bad in parts["bad"]] == ["bomb.3mf"]
    assert server.get("/api/jobs").status == 200


def test_who_does_not_go_on_is_let_go(start_server):
    """Connections that say nothing hold nobody up, and end."""
    server = start_server()
    silent = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(50)]
    for connection in silent[:25]:
        connection.sendall(b"PUT /api/jobs HTTP/1.1\r\nHost: ")
    begun = time.monotonic()
    assert server.get("/api/jobs").status == 200
    assert time.monotonic() - begun < 5
    for connection in silent:
        connection.close()


def test_files_do_not_change_under_a_run(server):
    job = sample_job(server, voxel=0.5)
    server.ask("POST", f"/api/jobs/{job}/start")
    refused(server.put_file(job, "gear.stl", b"x"), 409, "stop it first")
    refused(server.ask("DELETE", f"/api/jobs/{job}/files/gear.stl"), 409)
    refused(server.ask("PUT", f"/api/jobs/{job}/job.json", {"parts": []}), 409)
    refused(server.ask("POST", f"/api/jobs/{job}/start"), 409)
    server.ask("POST", f"/api/jobs/{job}/cancel")
    server.wait(job)


def test_a_folder_that_is_in_use(server):
    from conftest import PROGRAM
    import subprocess
    second = subprocess.run([PROGRAM, "serve", "--dir", server.folder, "--no-browser"], capture_output=True, text=True)
    assert second.returncode == 2 and f":{server.port}/" in second.stderr
    assert os.path.exists(server.folder)
