#!/usr/bin/env python3
"""Delaunay triangulation: the generic text in N|F|F2N|F2F (in space N|R|R2N|R2R), the same algorithm written by hand,
two threads, and CGAL, in turn, each a process of its own, on the same points. Prints one JSON object a point
set; asserts nothing but that all give the same cells.

    bench/delaunay.py [--dim 2|3] [--build DIR] [--peers DIR] [--runs N] SPEC ...

SPEC: random:N:SEED, grid:N, circle:N, clusters:N:SEED, or a text file of points, of which the first two or three
coordinates are taken (may be .xz)."""
import argparse
import array
import json
import lzma
import os
import subprocess
import tempfile

from alternate import alternate, ratios, summary


def shared_points(spec, dim, gmds, folder):
    """The name under which every program finds the points: made-up ones by recipe, others as a file of raw doubles."""
    if spec.split(":")[0] in ("random", "grid"):
        return spec
    raw = os.path.join(folder, "points.f64")
    if spec.split(":")[0] in ("circle", "clusters"):
        subprocess.run([gmds, "convert", spec, raw, "--dim", str(dim)], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        return raw
    with (lzma.open if spec.endswith(".xz") else open)(spec, "rt") as text, open(raw, "wb") as out:
        for line in text:
            numbers = line.split("#")[0].replace(",", " ").split()
            if numbers:
                array.array("d", map(float, numbers[:dim])).tofile(out)
    return raw


def measure(spec, options, folder):
    gmds = os.path.join(options.build, "bin", "gmds")
    dim = str(options.dim)
    points = shared_points(spec, options.dim, gmds, folder)
    handwritten = "handwritten_delaunay3" if options.dim == 3 else "handwritten_delaunay"
    sides = {
        "generic": [gmds, "delaunay", points, "--dim", dim, "--json"],
        "handwritten": [os.path.join(options.build, "bin", handwritten), points],
        "two_threads": [gmds, "delaunay", points, "--dim", dim, "--json", "--threads", "2"],
    }
    if options.peers:
        sides["cgal"] = [os.path.join(options.peers, "cgal_delaunay"), dim, points]
    reports = alternate(sides, options.runs)
    checksums = {one["checksum"] for side in reports.values() for one in side}
    if len(checksums) != 1:
        raise SystemExit(f"{spec}: the programs do not agree: {sorted(checksums)}")
    one = reports["generic"][0]
    result = {
        "spec": spec,
        "dim": options.dim,
        "points": one["points"],
        "runs": options.runs,
        "checksum": one["checksum"],
        "bytes_per_point": one["bytes"] / max(one["points"], 1),
        "peak_bytes_per_point": one["peak_bytes"] / max(one["points"], 1),
        "seconds": {name: summary([r["seconds"] for r in side]) for name, side in reports.items()},
        "generic_over_handwritten": ratios(reports, "generic", "handwritten"),
        "one_thread_over_two": ratios(reports, "generic", "two_threads"),
    }
    if options.peers:
        result["cgal_over_generic"] = ratios(reports, "cgal", "generic")
        result["cgal_over_handwritten"] = ratios(reports, "cgal", "handwritten")
        result["cgal_bytes_per_point"] = reports["cgal"][0]["bytes_per_point"]
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--dim", type=int, choices=(2, 3), default=2, help="dimension (default 2)")
    parser.add_argument("--build", default="build", help="build folder of gmds (default build)")
    parser.add_argument("--peers", help="folder of cgal_delaunay; without it CGAL is left out")
    parser.add_argument("--runs", type=int, default=7, help="counted turns (default 7)")
    parser.add_argument("spec", nargs="+")
    options = parser.parse_args()
    if options.runs < 5:
        parser.error("--runs: a median of fewer than 5 turns says little")
    for spec in options.spec:
        with tempfile.TemporaryDirectory() as folder:
            print(json.dumps(measure(spec, options, folder)), flush=True)


if __name__ == "__main__":
    main()
