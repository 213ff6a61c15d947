#!/usr/bin/python3 -Es
"""PySPH's own example of the elliptical drop, measured: its error and what it costs. The study work_precision_sph runs it.

pysph.examples.elliptical_drop as Debian ships it: WCSPH, Gaussian kernel with h = 1.3 dx, alpha = 0.1, c0 = 14 R A0,
adaptive dt, double, one thread, to t A0 = 0.76. Nothing of it is changed. For each of the resolutions it prints a line of
JSON, one process for all of them, so that PySPH compiles once.

`b_error` is that of the outermost particle along y, which starts at R, against the exact semi-axis; `energy_error` that of
the kinetic energy, which cannot change; `largest` is over all steps. PySPH evaluates once per step. The clock, CPU time of
the process, starts before the first step, after the one evaluation before it, and stands while this script looks at the
particles: neither start-up nor compiling counts. What PySPH compiles goes to a temporary folder.

Exit codes: 0 done, 2 usage, 69 PySPH is not installed.
"""
import argparse
import contextlib
import json
import os
import signal
import sys
import tempfile
import time

WORDS = {
    "usage": "%(prog)s [--nx N [N ...]]",
    "nx": "particles along the radius, R/dx (default: 20 40)",
    "bad_nx": "%s is not a whole number of 5 to 500.",
    "missing": "PySPH is not there (%s): ./lab bench --peer pysph installs it.",
}

try:
    import numpy as np
    import pysph
    from pysph.examples.elliptical_drop import EllipticalDrop, exact_solution
except ImportError as missing:
    print(WORDS["missing"] % missing, file=sys.stderr)
    sys.exit(69)

A0 = 100.0  # of the example [1/s]; R = 1


def resolution(text):
    if not text.isdecimal() or not 5 <= int(text) <= 500:
        raise argparse.ArgumentTypeError(WORDS["bad_nx"] % text)
    return int(text)


class Drop(EllipticalDrop):
    """The example, with a look at the particles before each step."""

    def create_particles(self):
        particles = super().create_particles()
        self.fluid, self.cpu, self.resumed = particles[0], 0.0, None
        self.start = self.kinetic_energy()
        self.b_largest = self.energy_largest = 0.0
        return particles

    def kinetic_energy(self):
        fluid = self.fluid
        return float(np.sum(fluid.m * (fluid.u**2 + fluid.v**2)) / 2)

    def energy_error(self):
        return self.kinetic_energy() / self.start - 1

    def b_error(self, t):
        return float(self.fluid.y.max() * exact_solution(t, n=0)[0] - 1)  # b = R^2/a

    def look(self, t):
        self.b_largest = max(self.b_largest, abs(self.b_error(t)))
        self.energy_largest = max(self.energy_largest, abs(self.energy_error()))

    def count_time(self):
        if self.resumed is not None:
            self.cpu += time.process_time() - self.resumed

    def pre_step(self, solver):
        self.count_time()
        self.look(solver.t)
        self.resumed = time.process_time()


def run(nx):
    with tempfile.TemporaryDirectory(prefix="clapotis-pysph-") as output:
        app = Drop(fname="elliptical_drop", output_dir=output)
        app.setup(["--quiet", "--disable-output", "--loglevel", "none", "--no-openmp", "--nx", str(nx)])
        app.solver.solve(show_progress=False)
        app.count_time()
        app.look(app.solver.t)
    return {
        "peer": "pysph",
        "version": pysph.__version__,
        "nx": nx,
        "particles": len(app.fluid.x),
        "steps": app.solver.count,
        "t_A0": app.solver.t * A0,
        "b_error": app.b_error(app.solver.t),
        "b_largest": app.b_largest,
        "energy_error": app.energy_error(),
        "energy_largest": app.energy_largest,
        "cpu_seconds": app.cpu,
    }


def main():
    parser = argparse.ArgumentParser(usage=WORDS["usage"], description=__doc__.splitlines()[0], allow_abbrev=False)
    parser.add_argument("--nx", type=resolution, nargs="+", default=[20, 40], help=WORDS["nx"])
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the temporary folders go as well
    try:
        with tempfile.TemporaryDirectory(prefix="clapotis-pysph-") as home:
            os.environ["HOME"] = home  # PySPH keeps there what it compiles
            for nx in options.nx:
                with contextlib.redirect_stdout(sys.stderr):
                    result = run(nx)
                print(json.dumps(result), flush=True)
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
