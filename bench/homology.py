#!/usr/bin/python3
"""Figures 5 and 6 and Table 1 of "Parallel homology computation of meshes", and the comparison with CGAL and GUDHI, made by
`gmds homology` and, where their folder is given, programs of the other side. Every time is of a process of its own, the
sides of a comparison in turn; medians with the smallest and largest. Seconds are of the simplification; `build` makes the
2-map from the list of faces, and no time has reading in it.

    bench/homology.py [--build DIR] [--peers DIR] [--out DIR] [--runs N] SURFACE ...

SURFACE: torus:N, sphere:N, or a file (may be .xz). Writes to DIR (default out/homology):
    table1.csv     edges removed and contracted in each step, sequential (S1 to S3) and in an 8 x 8 x 8 grid (P1a to P3)
    figure5b.csv   seconds of the sequential algorithm, and of ranges and the grid with 8 threads
    figure6.csv    seconds of ranges with 1, 2, 4 and 8 threads, and of building with as many
    figure5b.svg, figure6.svg
    peers.json     torus:1300, in order and with its faces shuffled, beside CGAL; torus:700 beside GUDHI
Needs python3-matplotlib."""
import argparse
import csv
import json
import lzma
import math
import os
import random
import shutil
import tempfile

from alternate import alternate, ratios, summary

try:
    import matplotlib
except ImportError:
    raise SystemExit("bench/homology.py needs python3-matplotlib (and on Debian /usr/bin/python3, to which it belongs)")

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "gmds"
matplotlib.rcParams["font.size"] = 9
import matplotlib.pyplot as plt  # noqa: E402

STEPS = ("inner", "critical", "dangling", "contract")
THREADS = (1, 2, 4, 8)


def simplification(report):
    return sum(report["seconds"][step] for step in STEPS)


def whole(report):
    return sum(report["seconds"].values())


def unpacked(surface, folder):
    if not surface.endswith(".xz"):
        return surface
    path = os.path.join(folder, os.path.basename(surface)[:-3])
    with lzma.open(surface, "rb") as packed, open(path, "wb") as out:
        shutil.copyfileobj(packed, out)
    return path


def name_of(surface):
    return os.path.basename(surface).removesuffix(".xz").rsplit(".", 1)[0]


def shuffled_torus(n, path):
    """torus:N with its faces in random order, as an OFF file."""
    faces = []
    for i in range(n):
        for j in range(n):
            a, b, c, d = (p * n + q for p, q in ((i, j), ((i + 1) % n, j), ((i + 1) % n, (j + 1) % n), (i, (j + 1) % n)))
            faces += [f"3 {a} {b} {c}\n", f"3 {a} {c} {d}\n"]
    random.Random(1).shuffle(faces)
    turn = [2 * math.pi * k / n for k in range(n)]
    with open(path, "w") as out:
        out.write(f"OFF\n{n * n} {len(faces)} 0\n")
        for u in turn:
            out.writelines(f"{(3 + math.cos(v)) * math.cos(u)} {(3 + math.cos(v)) * math.sin(u)} {math.sin(v)}\n"
                           for v in turn)
        out.writelines(faces)


def measure(surface, options, folder):
    """The reports of the sequential algorithm, of the grid, and of ranges by each number of threads."""
    command = [os.path.join(options.build, "bin", "gmds"), "homology", unpacked(surface, folder), "--json"]
    sides = {"sequential": command + ["--clusters", "one"], "grid": command + ["--clusters", "grid", "--threads", "8"]}
    for threads in THREADS:
        sides[threads] = command + ["--threads", str(threads)]
    return alternate(sides, options.runs)


def write_tables(results, options):
    with open(os.path.join(options.out, "table1.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["surface", "vertices", "faces", "b0", "b1", "b2", "S1", "S2", "S3", "P1a", "P1b", "P2", "P3"])
        for name, reports in results.items():
            one, grid = reports["sequential"][0], reports["grid"][0]
            removed = [side["removed"][step] for side, steps in
                       ((one, ("inner", "dangling", "contracted")),
                        (grid, ("inner", "critical", "dangling", "contracted"))) for step in steps]
            out.writerow([name, one["vertices"], one["faces"], *one["betti"], *removed])
    with open(os.path.join(options.out, "figure5b.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["surface", "faces", "sequential", "ranges", "grid"])
        for name, reports in results.items():
            out.writerow([name, reports["sequential"][0]["faces"],
                          *(f"{summary([simplification(r) for r in reports[s]])['median']:.6f}" for s in ("sequential", 8, "grid"))])
    with open(os.path.join(options.out, "figure6.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["surface", "faces", "threads", "build", *STEPS, "simplification"])
        for name, reports in results.items():
            for threads in THREADS:
                medians = [summary([r["seconds"][step] for r in reports[threads]])["median"] for step in ("build", *STEPS)]
                total = summary([simplification(r) for r in reports[threads]])["median"]
                out.writerow([name, reports[threads][0]["faces"], threads, *(f"{x:.6f}" for x in (*medians, total))])


def plot(results, options):
    names = list(results)
    figure, axes = plt.subplots(figsize=(7, 3.2))
    for k, (side, label) in enumerate((("sequential", "sequential"), (8, "ranges, 8 threads"), ("grid", "grid, 8 threads"))):
        medians = [summary([simplification(r) for r in results[name][side]])["median"] for name in names]
        axes.bar([x + 0.27 * (k - 1) for x in range(len(names))], medians, 0.27, label=label)
    axes.set_xticks(range(len(names)), names, rotation=25, ha="right")
    axes.set_ylabel("seconds")
    axes.set_yscale("log")
    axes.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(options.out, "figure5b.svg"), metadata={"Date": None})
    figure, axes = plt.subplots(figsize=(7, 3.2))
    for name in names:
        medians = [summary([simplification(r) for r in results[name][threads]])["median"] for threads in THREADS]
        axes.plot(THREADS, medians, marker="o", label=name)
    axes.set_xscale("log", base=2)
    axes.set_xticks(THREADS, THREADS)
    axes.set_yscale("log")
    axes.set_xlabel(f"threads (on {os.cpu_count()} cores)")
    axes.set_ylabel("seconds")
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(os.path.join(options.out, "figure6.svg"), metadata={"Date": None})


def compare(options, folder):
    """torus:1300 beside CGAL's map, torus:700 beside GUDHI."""
    gmds = [os.path.join(options.build, "bin", "gmds"), "homology"]
    shuffled = os.path.join(folder, "shuffled.off")
    shuffled_torus(1300, shuffled)
    sides = {"one": gmds + ["torus:1300", "--json"], "sequential": gmds + ["torus:1300", "--clusters", "one", "--json"],
             "two": gmds + ["torus:1300", "--threads", "2", "--json"], "shuffled": gmds + [shuffled, "--json"]}
    small = {"gmds": gmds + ["torus:700", "--json"]}
    if options.peers:
        sides["cgal"] = [os.path.join(options.peers, "cgal_homology"), "1300"]
        small["gudhi"] = [os.path.join(options.peers, "gudhi_homology"), "700"]
    reports, smaller = alternate(sides, options.runs), alternate(small, options.runs)
    result = {
        "torus:1300": {side: {"build": summary([r["seconds"]["build"] for r in reports[side]]),
                              "simplification": summary([whole(r) - r["seconds"]["build"] for r in reports[side]])}
                       for side in sides},
        "one / two threads": ratios(reports, "one", "two", simplification),
        "one / two threads, building too": ratios(reports, "one", "two", whole),
        "torus:700": {side: summary([whole(r) for r in smaller[side]]) for side in small},
    }
    if options.peers:
        result["cgal / gmds, building too"] = ratios(reports, "cgal", "one", whole)
        result["gudhi / gmds, building too"] = ratios(smaller, "gudhi", "gmds", whole)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build")
    parser.add_argument("--peers")
    parser.add_argument("--out", default="out/homology")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("surfaces", nargs="*", default=["torus:200", "torus:700", "torus:1300", "sphere:300"])
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        results = {name_of(surface): measure(surface, options, folder) for surface in options.surfaces}
        write_tables(results, options)
        plot(results, options)
        with open(os.path.join(options.out, "peers.json"), "w") as file:
            json.dump(compare(options, folder), file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
