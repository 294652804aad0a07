"""The preview for browsers, from outside: browser_preview.py PROGRAM

An editor on standard input and output, browsers at the address that it is told of. Who does not know the token or comes by another
name gets nothing; browsers get pictures, and have the editor write a value and show a place.
"""

import base64
import contextlib
import http.client
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import urllib.parse

URI = "file:///papers/my%20paper.tex"
TEXT = "\\begin{equation}\n  k = 0.25\n\\end{equation}\n\\begin{equation}\n  f = k * \\cos\\theta_h * \\vec{1, 1, 1}\n\\end{equation}\n"
PATIENCE = 120  # seconds for everything: a machine may be busy


class Peer:
    """Who sends messages; those that nobody has waited for yet are kept."""

    def wait(self, fits):
        for index, message in enumerate(self.kept):
            if fits(message):
                return self.kept.pop(index)
        while not fits(message := self.read()):
            self.kept.append(message)
        return message


class Editor(Peer):
    """Speaks LSP. Keeps what it did not look for yet."""

    def __init__(self, program, log):
        command = [program, "lsp", "--preview-port", "0", "--log-file", log, "--log-level", "debug"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.kept = []
        self.last_id = 0

    def write(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        self.process.stdin.flush()

    def notify(self, method, params):
        self.write({"method": method, "params": params})

    def request(self, method, params):
        self.last_id += 1
        self.write({"id": self.last_id, "method": method, "params": params})
        return self.wait(lambda message: message.get("id") == self.last_id and "method" not in message)["result"]

    def read(self):
        length = 0
        while line := self.process.stdout.readline().strip():
            name, _, value = line.partition(b":")
            if name == b"Content-Length":
                length = int(value)
        if not length:
            sys.exit("the server ended")
        return json.loads(self.process.stdout.read(length))

    def wait_for(self, method):
        return self.wait(lambda message: message.get("method") == method)


class Browser(Peer):
    """A page with its stream of events."""

    def __init__(self, url):
        self.url = url
        self.stream = http.client.HTTPConnection(url.hostname, url.port)
        self.stream.request("GET", url.path + "events")
        self.events = self.stream.getresponse()
        assert self.events.status == 200 and self.events.headers["Content-Type"] == "text/event-stream"
        self.kept = []
        self.last_id = 0
        self.client = self.wait_for("texbrdf/welcome")["client"]

    def read(self):
        data = []
        while line := self.events.readline().decode().rstrip("\n"):
            assert line.startswith("data: "), line
            data.append(line.removeprefix("data: "))
        assert data, "the stream ended"
        return json.loads("\n".join(data))

    def wait_for(self, method):
        return self.wait(lambda message: message.get("method") == method)["params"]

    def post(self, *messages):
        body = "\n".join(json.dumps({"jsonrpc": "2.0", **message}) for message in messages)
        status = fetch(self.url, f"messages/{self.client}", "POST", {"Content-Type": "application/json"}, body)[0]
        assert status == 202, status

    def notify(self, method, params):
        self.post({"method": method, "params": params})

    def ask(self, method, params):
        self.last_id += 1
        self.post({"id": self.last_id, "method": method, "params": params})
        return self.wait(lambda message: message.get("id") == self.last_id)

    def request(self, method, params):
        return self.ask(method, params)["result"]

    def refused(self, method, params):
        return self.ask(method, params)["error"]["code"]

    def next_frame(self, preview, version):
        """The first of the version; all before are acknowledged."""
        while True:
            frame = self.wait_for("texbrdf/frame")
            assert frame["preview"] == preview, frame["preview"]
            self.notify("texbrdf/frameShown", {"preview": preview})
            if frame["version"] == version:
                return frame


def fetch(url, path="", method="GET", headers=None, body=None):
    connection = http.client.HTTPConnection(url.hostname, url.port)
    with contextlib.closing(connection):
        connection.putrequest(method, url.path + path, skip_host="Host" in (headers or {}))
        for name, value in (headers or {}).items():
            connection.putheader(name, value)
        if body is not None:
            connection.putheader("Content-Length", str(len(body)))
        connection.endheaders(body.encode() if body is not None else None)
        response = connection.getresponse()
        return response.status, response.headers, response.read().decode()


def begin(editor):
    """The address, as a user learns it."""
    capabilities = {"workspace": {"applyEdit": True, "workspaceEdit": {"documentChanges": True}}, "window": {"showDocument": {"support": True}}}
    result = editor.request("initialize", {"capabilities": capabilities})
    assert result["capabilities"]["executeCommandProvider"] == {"commands": ["texbrdf.openPreview"]}, result
    editor.notify("initialized", {})
    message = editor.wait_for("window/showMessage")["params"]
    prefix, _, url = message["message"].partition(": ")
    assert prefix == "BRDF preview" and message["type"] == 3, message
    return urllib.parse.urlsplit(url)


def check_who_is_let_in(url):
    assert url.hostname == "127.0.0.1" and len(url.path) == 24, url
    status, headers, page = fetch(url)
    assert status == 200 and "texbrdf preview" in page, page
    policy = headers["Content-Security-Policy"]
    assert policy.startswith("default-src 'none'") and "frame-ancestors 'none'" in policy and "unsafe" not in policy, policy
    assert not any(name.lower().startswith("access-control") for name in headers), headers
    host = f"localhost:{url.port}"
    assert fetch(url, headers={"Host": host})[0] == 200
    for other in (f"evil.example:{url.port}", "127.0.0.1", f"127.0.0.1:{url.port}.evil.example"):
        assert fetch(url, headers={"Host": other})[0] == 403, f"DNS rebinding by {other}"
        assert fetch(url, "events", headers={"Host": other})[0] == 403, other
    assert fetch(url, headers={"Origin": "http://evil.example"})[0] == 403
    wrong = "/" + url.path[2:-1] + ("0" if url.path[-2] != "0" else "1") + "/"
    for path in ("/", "/favicon.ico", "/events", wrong, wrong + "events", url.path[:-1]):
        assert fetch(url._replace(path=path))[0] == 404, path
    message = {"Content-Type": "application/json"}
    assert fetch(url._replace(path=wrong), "messages/1", "POST", message, "{}")[0] == 404
    assert fetch(url, "messages/99", "POST", message, "{}")[0] == 404, "there is no such client"
    assert fetch(url, "messages/1", "POST", {"Content-Type": "text/plain"}, "{}")[0] == 415
    assert fetch(url, "messages/1", "POST", message, "x" * 100000)[0] == 413
    return "<div id=\"stage\"" in page


def check_page(url):
    assert fetch(url, "preview.js")[1]["Content-Type"] == "text/javascript; charset=utf-8"
    assert fetch(url, "preview.css")[1]["Content-Type"] == "text/css; charset=utf-8"


def check_pictures(editor, browser, other):
    """Of a browser's preview, for it and nobody else."""
    opened = browser.request("texbrdf/openPreview", {"uri": URI, "view": "sphere", "width": 64, "height": 64})
    preview = opened["preview"]
    assert opened["root"] == "f", opened
    assert browser.wait_for("texbrdf/previewState")["state"] == "good"
    frame = browser.next_frame(preview, version=1)
    assert base64.b64decode(frame["png"]).startswith(b"\x89PNG"), frame["png"][:20]
    other.notify("texbrdf/closePreview", {"preview": preview})
    other.notify("texbrdf/updatePreview", {"preview": preview, "zoom": 3})
    assert other.request("texbrdf/roots", {"uri": URI})["root"] == "f"
    editor.notify("textDocument/didChange", {"textDocument": {"uri": URI, "version": 2}, "contentChanges": [
        {"range": {"start": {"line": 1, "character": 6}, "end": {"line": 1, "character": 10}}, "text": "0.75"}]})
    assert browser.next_frame(preview, version=2)["png"] != frame["png"]
    assert browser.wait_for("texbrdf/document")["version"] == 2
    own = editor.request("texbrdf/openPreview", {"uri": URI, "width": 32, "height": 32})["preview"]
    assert editor.wait_for("texbrdf/frame")["params"]["preview"] == own, "the editor's is the editor's"
    kept = [message.get("method") for message in other.kept]
    assert "texbrdf/frame" not in kept and "texbrdf/previewState" not in kept, kept
    return preview


def check_writing(editor, browser):
    """A browser has the editor write a value and show a place."""
    (parameter,) = browser.request("texbrdf/parameters", {"uri": URI})
    edit = browser.request("texbrdf/parameterEdit", {"uri": URI, "name": parameter["name"], "value": [0.5]})
    (document,) = edit["documentChanges"]
    change = {"uri": URI, "version": 2, **document["edits"][0]}
    number = browser.request("texbrdf/applyEdit", {"changes": [change]})["edit"]
    asked = editor.wait_for("workspace/applyEdit")
    assert asked["params"]["edit"] == edit, asked
    editor.write({"id": asked["id"], "result": {"applied": True}})
    assert browser.wait_for("texbrdf/edited") == {"edit": number, "applied": True}
    failed = -32803
    assert browser.refused("texbrdf/applyEdit", {"changes": [{**change, "version": 1}]}) == failed, "an old version"
    assert browser.refused("texbrdf/applyEdit", {"changes": [{**change, "uri": "file:///etc/passwd"}]}) == failed
    assert browser.refused("texbrdf/applyEdit", {"changes": [{**change, "newText": "a\nb"}]}) == failed, "no value"
    place = parameter["location"]
    browser.request("texbrdf/reveal", place)
    shown = editor.wait_for("window/showDocument")["params"]
    assert shown == {"uri": URI, "takeFocus": True, "selection": place["range"]}, shown
    assert browser.refused("texbrdf/reveal", {**place, "uri": "https://evil.example/"}) == failed


def check_what_browsers_may_not(browser):
    missing = -32601
    for method in ("textDocument/hover", "shutdown", "initialize", "texbrdf/stats", "workspace/executeCommand"):
        assert browser.refused(method, {}) == missing, method
    browser.notify("exit", {})
    browser.notify("textDocument/didClose", {"textDocument": {"uri": URI}})
    browser.post({"id": 1, "result": None})
    fetch(browser.url, f"messages/{browser.client}", "POST", {"Content-Type": "application/json"}, "{\n\n[]\n")
    assert browser.wait(lambda message: "error" in message and message["id"] is None)["error"]["code"] == -32700
    assert browser.request("texbrdf/roots", {"uri": URI})["root"] == "f"
    count = 500
    browser.post(*({"id": f"many {i}", "method": "texbrdf/roots", "params": {"uri": URI}} for i in range(count)))
    for i in range(count):
        assert browser.wait(lambda message: isinstance(message.get("id"), str))["id"] == f"many {i}", "answers come in the order of the questions"


def check_command(editor, url):
    result = editor.request("workspace/executeCommand", {"command": "texbrdf.openPreview", "arguments": []})
    assert result == url.geturl(), result
    shown = editor.wait_for("window/showDocument")["params"]
    assert shown == {"uri": url.geturl(), "external": True}, shown


def wait_for_line(log, part):
    while part not in log.read_text(encoding="utf-8"):
        time.sleep(0.01)


def main(program):
    signal.alarm(PATIENCE)
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "log")
        editor = Editor(program, str(log))
        url = begin(editor)
        assert url.geturl() in log.read_text(encoding="utf-8")
        if check_who_is_let_in(url):
            check_page(url)
        browser, other = Browser(url), Browser(url)
        assert browser.wait_for("texbrdf/document") == {"uri": None}
        editor.notify("textDocument/didOpen", {"textDocument": {"uri": URI, "languageId": "latex", "version": 1, "text": TEXT}})
        assert browser.wait_for("texbrdf/document") == {"uri": URI, "name": "my paper.tex", "version": 1}
        preview = check_pictures(editor, browser, other)
        check_writing(editor, browser)
        check_what_browsers_may_not(other)
        check_command(editor, url)

        browser.stream.close()
        browser.events.close()
        wait_for_line(log, f"browser {browser.client} is gone")
        late = Browser(url)
        assert late.wait_for("texbrdf/document")["version"] == 2
        late.notify("texbrdf/updatePreview", {"preview": preview, "zoom": 2})
        assert late.request("texbrdf/openPreview", {"uri": URI, "width": 32, "height": 32})["preview"] > preview
        editor.notify("textDocument/didClose", {"textDocument": {"uri": URI}})
        assert late.wait_for("texbrdf/document") == {"uri": None}
        editor.request("shutdown", None)
        editor.notify("exit", None)
        assert editor.process.wait() == 0
        while late.events.readline():
            pass  # ends, because the stream does
    return 0


sys.exit(main(sys.argv[1]))
