#!/usr/bin/python3
"""Table 4 and Figure 8 of "A generic and flexible framework for 2D and 3D multi-model meshes", and more of the same: time
and memory of one Bowyer-Watson text per mesh model, made by `gmds sweep` alone.

    bench/models.py [--dim 2|3] [--build DIR] [--out DIR] [--runs N] [--large POINTS]

Writes to DIR (default out/models):
    table4.csv     the 17 models of Table 4 at 1225 points, the paper's seconds and bytes beside ours
    figure8.csv    all 114 models and some that borrow a relation, at 2,500, 5,000, ... 40,000 and 400,000 points; a model that
                   took more than a quarter of a second drops out of the next size
    models.svg     time against bytes, one dot a model, at 1225 and 400,000 points, the Pareto front named
    figure8.svg    time and bytes against the number of points
In space only figure8.csv, the named models F1 to F6, R1 to R4 and N|R|R2N|R2R at 500, 1,000, ... 16,000 points.
Seconds are medians of N sweeps (default 5), one model at a time. Needs python3-matplotlib."""
import argparse
import csv
import os
import statistics
import subprocess

try:
    import matplotlib
except ImportError:
    raise SystemExit("bench/models.py needs python3-matplotlib (and on Debian /usr/bin/python3, to which it belongs)")

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "gmds"
matplotlib.rcParams["font.size"] = 9
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter  # noqa: E402

# Table 4: the paper's seconds ("< 1" as 1) and bytes.
PAPER = {
    "N|F|N2F|F2N": (1, 2334720), "N|F|N2F|F2N|F2F": (1, 2342912), "N|E|F|N2F|F2N|F2E": (1, 3526656),
    "N|E|F|N2F|F2N|F2E|F2F": (1, 3547136), "N|E|F|N2F|E2F|F2N|F2E": (1, 4038656),
    "N|E|F|N2E|N2F|E2F|F2N": (1, 5672960), "N|E|F|N2E|N2F|E2F|F2N|F2F": (1, 5726208),
    "N|E|F|N2E|N2F|E2N|F2N|F2E|F2F": (1, 5332992), "N|E|F|N2E|N2F|E2N|E2F|F2N|F2E|F2F": (1, 5902336),
    "N|F|N2F|F2F": (49, 2314240), "N|E|F|N2E|N2F|F2F": (50, 5136384), "N|F|N2F": (55, 2289664),
    "N|F|F2N": (90, 942080), "N|F|F2N|F2F": (91, 987136), "N|E|F|N2E|E2F": (541, 4567040),
    "N|E|F|E2N|F2E": (2129, 1454080), "N|E|F|E2N|F2E|F2F": (2243, 1499136)}
BORROWED = ["N|F|F2N +N2F", "N|F|F2N +F2F", "N|F|N2F +F2N"]
SIZES = [2500, 5000, 10000, 20000, 40000]
SPACE_SIZES = [500, 1000, 2000, 4000, 8000, 16000]
PATIENCE = 0.25  # seconds after which a model drops out of the next size


def sweep(options, points, models):
    """The rows of `gmds sweep`, with the median of the seconds."""
    seconds, rows = {}, {}
    for _ in range(options.runs):
        path = os.path.join(options.out, "sweep.tmp.csv")
        subprocess.run([os.path.join(options.build, "bin", "gmds"), "sweep", "--dim", str(options.dim), "--points",
                        f"random:{points}:1", "--models", models, "--csv", path], check=True, stdout=subprocess.DEVNULL)
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                if row["status"] != "ok":
                    raise SystemExit(f"{row['model']}: {row['status']}")
                rows[row["model"]] = row
                seconds.setdefault(row["model"], []).append(float(row["seconds"]))
        os.remove(path)
    for model, row in rows.items():
        row["seconds"] = statistics.median(seconds[model])
        for key in ("points", "cells", "bytes", "peak_bytes"):
            row[key] = int(row[key])
    return list(rows.values())


def write_csv(options, name, rows, keys):
    with open(os.path.join(options.out, name), "w", newline="") as file:
        writer = csv.DictWriter(file, keys, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def pareto(rows):
    """The rows that no other beats in both time and bytes."""
    front, best = [], float("inf")
    for row in sorted(rows, key=lambda r: (r["bytes"], r["seconds"])):
        if row["seconds"] < best:
            front.append(row)
            best = row["seconds"]
    return front


def plot_models(axes, rows, title):
    front = pareto(rows)
    axes.loglog([r["bytes"] / r["points"] for r in rows], [1e6 * r["seconds"] / r["points"] for r in rows], "o", ms=3.5,
                color="0.65", mec="0.4", mew=0.4, label="a model")
    axes.loglog([r["bytes"] / r["points"] for r in front], [1e6 * r["seconds"] / r["points"] for r in front], "o-", ms=4.5,
                color="#b2182b", lw=1, label="Pareto front")
    for row in front:
        axes.annotate(row["model"], (row["bytes"] / row["points"], 1e6 * row["seconds"] / row["points"]), xytext=(5, 5),
                      textcoords="offset points", fontsize=7, color="#b2182b")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(FormatStrFormatter("%g"))
        axis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("bytes a point, at the end")
    axes.set_ylabel("microseconds a point")
    axes.set_title(title, fontsize=9)
    axes.grid(True, which="both", lw=0.3, color="0.9")
    axes.legend(frameon=False, fontsize=7)


def print_front(rows):
    print(f"{rows[0]['points']} points, {len(rows)} models; Pareto front:")
    for row in pareto(rows):
        print(f"    {row['model']}: {row['seconds'] * 1e3:.2f} ms, {row['bytes']} bytes")


def scale(options, models, sizes):
    """A sweep for each size, of the models that the size before left."""
    scaling = []
    for points in sizes:
        rows = sweep(options, points, models)
        scaling.append(rows)
        models = ",".join(row["model"] for row in rows if row["seconds"] < PATIENCE)
        if not models:
            break
    write_csv(options, "figure8.csv", [row for rows in scaling for row in rows],
              ["model", "points", "cells", "seconds", "bytes", "peak_bytes", "checksum"])
    return scaling


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--dim", type=int, choices=(2, 3), default=2)
    parser.add_argument("--build", default="build")
    parser.add_argument("--out", default="out/models")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--large", type=int, default=400000, help="the largest number of points (default 400000)")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    if options.dim == 3:
        for rows in scale(options, "named", SPACE_SIZES):
            print_front(rows)
        return

    table4 = sweep(options, 1225, "table4")
    for row in table4:
        row["paper_seconds"], row["paper_bytes"] = PAPER[row["model"]]
        row["bytes_ratio"] = f"{row['paper_bytes'] / row['bytes']:.1f}"
    write_csv(options, "table4.csv", table4, ["model", "seconds", "bytes", "peak_bytes", "paper_seconds", "paper_bytes",
                                              "bytes_ratio", "checksum"])

    everything = sweep(options, 1225, "all")
    models = [row["model"] for row in everything] + BORROWED
    scaling = scale(options, ",".join(models), SIZES + [options.large])

    figure, axes = plt.subplots(1, 2, figsize=(10, 4.4))
    plot_models(axes[0], everything, f"all {len(everything)} models, 1225 points")
    plot_models(axes[1], scaling[-1], f"models with local queries, some that borrow a relation, {options.large:,} points")
    figure.tight_layout()
    figure.savefig(os.path.join(options.out, "models.svg"), metadata={"Date": None})

    shown = ["N|F|F2N|F2F", "N|F|N2F|F2N|F2F", "N|F|N2F|F2N", "N|E|F|N2E|N2F|E2N|E2F|F2N|F2E|F2F", "N|F|F2N +F2F",
             "N|F|F2N +N2F", "N|F|F2N"]
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.4))
    for model in shown:
        rows = [row for rows in scaling for row in rows if row["model"] == model]
        for k, key in enumerate(("seconds", "peak_bytes")):
            axes[k].loglog([r["points"] for r in rows], [r[key] for r in rows], "o-", ms=3, lw=1, label=model)
    axes[0].set_ylabel("seconds")
    axes[1].set_ylabel("bytes at the peak")
    for k in range(2):
        axes[k].set_xlabel("points")
        axes[k].grid(True, which="both", lw=0.3, color="0.9")
    axes[0].legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(os.path.join(options.out, "figure8.svg"), metadata={"Date": None})

    for rows in [everything] + scaling:
        print_front(rows)


if __name__ == "__main__":
    main()
