"""The height of a character as its file stands without a clip, which artists' figures are told in: at the first frame of a clip it may lie."""

import json
import pathlib
import struct
import subprocess
import tempfile


def rest_height(program, file):
    """Of the shown body, in world units."""
    data = pathlib.Path(file).read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20 : 20 + length])
    document.pop("animations", None)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length :]
    with tempfile.TemporaryDirectory() as folder:
        still = pathlib.Path(folder) / "still.glb"
        still.write_bytes(struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)) + struct.pack("<I4s", len(text), b"JSON") + text + rest)
        told = subprocess.run([program, "info", still, "--json", "--tolerant"], check=True, capture_output=True, text=True).stdout
    return json.loads(told)["height"]
