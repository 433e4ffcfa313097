"""pictures.py EXAMPLES [ONE.h5 OTHER.h5] - runs the examples that draw results, and judges what they print and draw by
what the files hold: plot_result.py and compare_results.py for two results, depth_loop.py without any."""

import pathlib
import subprocess
import sys
import tempfile

import h5py
import matplotlib.image

examples, results = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]


def run(folder, script, *words):
    call = [sys.executable, str(examples / script), *words]
    return subprocess.run(call, check=True, stdout=subprocess.PIPE, text=True, cwd=folder).stdout


def require_drawn(picture, colours):
    """So many colours at least: curves, text and their soft edges; a scalogram has hundreds more."""
    pixels = (255 * matplotlib.image.imread(picture)).astype(int)
    found = len({tuple(pixel) for row in pixels[::2, ::2] for pixel in row})
    assert found >= colours, f"{picture}: {found} colours"


def require_near(printed, value, digits):
    assert abs(float(printed) - value) <= 0.51 * 10**-digits, f"{printed} is not {value}"


def plots(folder):
    with h5py.File(results[0]) as one, h5py.File(results[1]) as other:
        said = run(folder, "plot_result.py", results[0], "one.png").split()
        require_near(said[2], abs(one["signals/aba_filtered"][:]).max(), 1)  # printed to a tenth
        require_drawn(folder / "one.png", 200)
        head, *rows = run(folder, "compare_results.py", *results, "both.png").splitlines()
        assert len(rows) == len(one["features"]) > 20, rows
        for name, first, second, unit in (row.split() for row in rows):
            for printed, file in ((first, one), (second, other)):
                value = file["features"][name][()]
                assert printed == f"{value:.5g}", f"{name}: {printed} is not {value}"
            assert unit == one["features"][name].attrs["unit"]
        require_drawn(folder / "both.png", 20)


def loop(folder):
    peaks = []
    for line in run(folder, "depth_loop.py", "tiny").splitlines():
        *_, force, _, path = line.replace(",", "").split()
        with h5py.File(folder / path) as result:
            peaks.append(result["features/peak"][()])
            require_near(line.split("peak ")[1].split()[0], peaks[-1], 1)
            require_near(force, result["features/smallest_contact_force"][()] / 1000, 1)
    # A deeper dip of the same length shakes the wheel more.
    assert len(peaks) == 3 and peaks == sorted(peaks), peaks
    require_drawn(folder / "depths.png", 20)


with tempfile.TemporaryDirectory() as place:
    (plots if results else loop)(pathlib.Path(place))
print("as the files hold it")
