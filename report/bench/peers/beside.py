#!/usr/bin/python3 -Es
"""Runs a peer's dam break and ours in turns, with the peer's kernel, h/dx, viscosity and spacing, and prints both and
their ratios: medians of three turns, since a machine that others use too changes its speed from second to second.

beside.py PEER_SCRIPT STAGE4_PROGRAM FILE.json [PEER_OPTION...]: FILE.json is where the peer's script leaves its figures.
Ours runs as many steps as the peer did where the peer counted steps, or else as long in simulated time with the time step
that our scheme allows; one thread, double. An update is one particle of the fluid given its density rate, pressure and
acceleration once.
"""
import json
import statistics
import subprocess
import sys
import tempfile

WORDS = {
    "usage": "usage: beside.py PEER_SCRIPT STAGE4_PROGRAM FILE.json [PEER_OPTION...]",
    "turn": "turn %d of %d",
    "failed": "our dam break ended with exit code %d",
    "head": "{:<28}{:>14}{:>14}{:>10}",
    "updates": "M updates per second",
    "cost": "CPU s per simulated s",
    "steps": "steps",
    "ours": "Clapotis",
    "ratio": "ratio",
}


TURNS = 3


def run_ours(program, peer):
    """run.json of our dam break on the peer's terms."""
    options = ["--set", "spacing=%r" % peer["dx"], "--set", "kernel=wendland_c2", "--set", "h_over_dx=1.3",
               "--set", "alpha=0.1", "--threads", "1", "--json", "--force"]
    if peer["cpu_seconds_per_simulated_second"] is None:
        options += ["--steps", str(peer["steps"])]
    else:
        options += ["--until", repr(peer["simulated_seconds"])]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "dam_break", "--headless", "--out", folder + "/run", *options],
                              stdout=subprocess.PIPE, check=False)
    if done.returncode:
        sys.exit(WORDS["failed"] % done.returncode)
    return json.loads(done.stdout)


def run_peer(script, file, options, turn):
    """What the peer's script left in `file`; its own table is shown once."""
    done = subprocess.run([script, "--json", file, *options], check=False,
                          stdout=None if turn == 0 else subprocess.DEVNULL)
    if done.returncode:
        sys.exit(done.returncode)
    with open(file) as result:
        return json.load(result)


def main():
    if len(sys.argv) < 4:
        print(WORDS["usage"], file=sys.stderr)
        sys.exit(2)
    script, program, file = sys.argv[1:4]
    turns = []
    for turn in range(TURNS):
        print(WORDS["turn"] % (turn + 1, TURNS), file=sys.stderr)
        peer = run_peer(script, file, sys.argv[4:], turn)
        turns.append((run_ours(program, peer), peer))

    def line(name, ours, theirs, form, less_is_better=False):
        """Medians of both, and of the ratios."""
        pairs = [(ours(mine), theirs(peer)) for mine, peer in turns]
        ratio = statistics.median(b / a if less_is_better else a / b for a, b in pairs)
        print(WORDS["head"].format(WORDS[name], form % statistics.median(a for a, _ in pairs),
                                   form % statistics.median(b for _, b in pairs), "%.1f" % ratio))

    print(WORDS["head"].format("", WORDS["ours"], peer["peer"], WORDS["ratio"]))
    line("updates", lambda mine: mine["particle_updates_per_second"] / 1e6,
         lambda peer: peer["updates_per_second"] / 1e6, "%.2f")
    line("steps", lambda mine: mine["steps"], lambda peer: peer["steps"], "%d")
    if peer["cpu_seconds_per_simulated_second"] is not None:
        line("cost", lambda mine: mine["cpu_seconds"] / mine["simulated_seconds"],
             lambda peer: peer["cpu_seconds_per_simulated_second"], "%.2f", less_is_better=True)


main()
