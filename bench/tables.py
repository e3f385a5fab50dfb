#!/usr/bin/env python3
"""Turns what bench/delaunay.py prints into the table of docs/performance.md.

    bench/delaunay.py ... | bench/tables.py"""
import json
import os
import sys


def cell(ratio):
    return f"{ratio['median']:.2f} ({ratio['min']:.2f}–{ratio['max']:.2f})"


def main():
    rows = [json.loads(line) for line in sys.stdin]
    threads = any("one_thread_over_two" in r for r in rows)
    columns = ["points", "n", "seconds", "µs/point", "CGAL", "CGAL / generic", "generic / by hand"]
    columns += ["one thread / two"] * threads + ["B/point", "peak"]
    print("| " + " | ".join(columns) + " |")
    print("|" + "---|" * len(columns))
    for r in rows:
        seconds = {name: side["median"] for name, side in r["seconds"].items()}
        has_cgal = "cgal" in seconds
        print("| " + " | ".join([
            os.path.basename(r["spec"]).split(".")[0] if "/" in r["spec"] else f"`{r['spec']}`",
            f"{r['points']:,}",
            f"{seconds['generic']:.4f}",
            f"{seconds['generic'] / r['points'] * 1e6:.3f}",
            f"{seconds['cgal']:.4f}" if has_cgal else "",
            cell(r["cgal_over_generic"]) if has_cgal else "",
            cell(r["generic_over_handwritten"]),
            *([cell(r["one_thread_over_two"]) if "one_thread_over_two" in r else ""] * threads),
            f"{r['bytes_per_point']:.1f}",
            f"{r['peak_bytes_per_point']:.1f}",
        ]) + " |")


if __name__ == "__main__":
    main()
