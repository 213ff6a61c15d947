#!/usr/bin/python3 -Es
"""Runs our dam break beside a peer's, with the peer's kernel, h/dx, viscosity and spacing, and prints both and their ratios.

beside.py PEER.json STAGE4_PROGRAM: PEER.json is what the peer's script left. Ours runs as many steps as the peer did where
the peer counted steps, or else as long in simulated time with the time step that our scheme allows; one thread, double.
An update is one particle of the fluid given its density rate, pressure and acceleration once.
"""
import json
import subprocess
import sys
import tempfile

WORDS = {
    "usage": "usage: beside.py PEER.json STAGE4_PROGRAM",
    "failed": "our dam break ended with exit code %d",
    "head": "{:<28}{:>14}{:>14}{:>10}",
    "updates": "M updates per second",
    "cost": "CPU s per simulated s",
    "steps": "steps",
    "ours": "Clapotis",
    "ratio": "ratio",
}


def run_ours(program, peer):
    """run.json of our dam break on the peer's terms, run three times: the one with the median rate."""
    options = ["--set", "spacing=%r" % peer["dx"], "--set", "kernel=wendland_c2", "--set", "h_over_dx=1.3",
               "--set", "alpha=0.1", "--threads", "1", "--json", "--force"]
    if peer["cpu_seconds_per_simulated_second"] is None:
        options += ["--steps", str(peer["steps"])]
    else:
        options += ["--until", repr(peer["simulated_seconds"])]
    runs = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(3):
            done = subprocess.run([program, "dam_break", "--headless", "--out", folder + "/run", *options],
                                  stdout=subprocess.PIPE, check=False)
            if done.returncode:
                sys.exit(WORDS["failed"] % done.returncode)
            runs.append(json.loads(done.stdout))
    return sorted(runs, key=lambda run: run["particle_updates_per_second"])[1]


def main():
    if len(sys.argv) != 3:
        print(WORDS["usage"], file=sys.stderr)
        sys.exit(2)
    with open(sys.argv[1]) as file:
        peer = json.load(file)
    ours = run_ours(sys.argv[2], peer)
    print(WORDS["head"].format("", WORDS["ours"], peer["peer"], WORDS["ratio"]))

    def line(name, mine, other, ratio, form):
        print(WORDS["head"].format(WORDS[name], form % mine, form % other, "%.1f" % ratio))

    rate = ours["particle_updates_per_second"]
    line("updates", rate / 1e6, peer["updates_per_second"] / 1e6, rate / peer["updates_per_second"], "%.2f")
    line("steps", ours["steps"], peer["steps"], ours["steps"] / peer["steps"], "%d")
    if peer["cpu_seconds_per_simulated_second"] is not None:
        cost = ours["cpu_seconds"] / ours["simulated_seconds"]
        line("cost", cost, peer["cpu_seconds_per_simulated_second"],
             peer["cpu_seconds_per_simulated_second"] / cost, "%.2f")


main()
