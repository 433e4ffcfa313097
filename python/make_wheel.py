"""make_wheel.py CMAKE BUILD VERSION - packs the module, as CMake installs it, into BUILD/squat_studio-VERSION-*.whl for
this version of Python on this kind of machine. A wheel is a zip archive with three more files (PEP 427); it needs the
libraries that the module was linked with, which pip does not install."""

import base64
import hashlib
import pathlib
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

METADATA = """Metadata-Version: 2.1
Name: squat-studio
Version: {version}
Summary: Axle box acceleration at defects of a rail: the solver of Squat Studio as a module
License: GPL-3.0-or-later
Requires-Python: =={python}.*
Requires-Dist: numpy
"""

WHEEL = """Wheel-Version: 1.0
Generator: squat-studio
Root-Is-Purelib: false
Tag: {tag}
"""

READER = "squat/squat-reader"  # a program: pip leaves it the right to be run


def record_of(name, content):
    """A row of RECORD: name, digest, size."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}"


def pack(folder, build, version):
    python = f"{sys.version_info.major}{sys.version_info.minor}"
    tag = f"cp{python}-cp{python}-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
    files = {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
    info = f"squat_studio-{version}.dist-info"
    numbers = f"{sys.version_info.major}.{sys.version_info.minor}"
    files[info + "/METADATA"] = METADATA.format(version=version, python=numbers).encode()
    files[info + "/WHEEL"] = WHEEL.format(tag=tag).encode()
    rows = [record_of(name, content) for name, content in files.items()] + [f"{info}/RECORD,,"]
    files[info + "/RECORD"] = ("\n".join(rows) + "\n").encode()
    for earlier in build.glob("squat_studio-*.whl"):  # of other versions: one stays, which a pattern names
        earlier.unlink()
    wheel = build / f"squat_studio-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name == READER else 0o644) << 16
            archive.writestr(entry, content)
    return wheel


cmake, build, version = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
with tempfile.TemporaryDirectory() as folder:
    install = [cmake, "--install", str(build), "--component", "python", "--prefix", folder, "--strip"]
    subprocess.run(install, check=True, stdout=subprocess.DEVNULL)
    print(pack(pathlib.Path(folder), build, version))
