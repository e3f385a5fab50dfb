"""Runs programs in turn and sums up the seconds that each reports: what every measurement here is made with."""
import json
import statistics
import subprocess


def report(command):
    """The JSON object that a program prints."""
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)


def summary(values):
    return {"median": statistics.median(values), "min": min(values), "max": max(values)}


def alternate(sides, runs):
    """sides: {name: command}. Runs each once for nothing, then all in turn `runs` times. {name: list of reports}."""
    reports = {name: [] for name in sides}
    for turn in range(runs + 1):
        for name, command in sides.items():
            one = report(command)
            if turn:
                reports[name].append(one)
    return reports


def ratios(reports, slow, fast, key=lambda r: r["seconds"]):
    """The ratio slow / fast, turn by turn."""
    return summary([key(a) / key(b) for a, b in zip(reports[slow], reports[fast])])
