"""lbmpy's stream-and-collide kernels on a box of fluid: no walls, no force, no ghost exchange."""

import dataclasses
import re
import statistics
import time

import numpy
import pystencils
from lbmpy import LBMConfig, LBMOptimisation, LBStencil, Method, Stencil
from lbmpy.advanced_streaming import Timestep
from lbmpy.creationfunctions import create_lb_method, create_lb_update_rule
from pystencils import CreateKernelConfig, Target
from pystencils.jit.cpu import CpuJit
from pystencils.jit.cpu.compiler_info import CompilerInfo

LATTICES = ("D3Q15", "D3Q19")
PRECISIONS = {"double": "float64", "single": "float32"}
STREAMINGS = ("in-place", "pull")
# lbmpy's fastest in place of each lattice, as measured on the machine where the goal was set
IN_PLACE_PATTERNS = {"D3Q15": "aa", "D3Q19": "esotwist"}
BLOCK = 4  # steps timed together: even, since in place two kernels take turns


@dataclasses.dataclass(frozen=True)
class Form:
    """What an update is: lattice, precision, and how populations stream."""

    lattice: str
    precision: str
    streaming: str

    @staticmethod
    def of(lattice, precision, streaming):
        precision = {"float": "single"}.get(precision, precision)
        for name, value, known in (
            ("lattice", lattice, LATTICES),
            ("precision", precision, tuple(PRECISIONS)),
            ("streaming", streaming, STREAMINGS),
        ):
            if value not in known:
                raise SystemExit(f"{name} must be one of {', '.join(known)}: {name}={value}")
        return Form(lattice, precision, streaming)

    @property
    def bytes_per_update(self):
        """Each population read and written; with two arrays the line is read before it is written."""
        passes = 2 if self.streaming == "in-place" else 3
        return passes * int(self.lattice[3:]) * numpy.dtype(PRECISIONS[self.precision]).itemsize

    def __str__(self):
        return f"{self.lattice}/{self.precision}/{self.streaming}"


def target():
    """AVX-512 where the processor has it, else AVX2."""
    flags = re.search(r"^flags\s*:(.*)$", open("/proc/cpuinfo").read(), re.MULTILINE)[1].split()
    return Target.X86_AVX512 if "avx512f" in flags else Target.X86_AVX


def compiler():
    """The command that compiles the kernels, without its folders."""
    info = CompilerInfo.get_default()
    return " ".join([info.cxx()] + info.cxxflags())


class Kernel:
    """A compiled kernel and its populations, which stay between readings."""

    def __init__(self, form, size, pattern, cache):
        self.form = form
        self.pattern = "pull" if form.streaming == "pull" else pattern
        self._nodes = size**3
        start = time.perf_counter()
        stencil = LBStencil(Stencil[form.lattice])
        method = dict(
            stencil=stencil,
            method=Method.TRT,
            relaxation_rates=[1.6, 0.8],
            compressible=False,
            zero_centered=True,
        )
        data = pystencils.create_data_handling(
            (size,) * 3, default_ghost_layers=1, default_layout="fzyx"
        )
        dtype = PRECISIONS[form.precision]
        fields = [
            data.add_array(name, values_per_cell=stencil.Q, dtype=dtype, alignment=64)
            for name in (("src", "dst") if self.pattern == "pull" else ("src",))
        ]
        optimisation = LBMOptimisation(
            symbolic_field=fields[0],
            symbolic_temporary_field=fields[1] if self.pattern == "pull" else None,
        )
        config = CreateKernelConfig(target=target(), default_dtype=dtype, jit=CpuJit(objcache=cache))
        config.cpu.openmp.enable = True
        config.cpu.vectorize.enable = True
        config.cpu.vectorize.assume_inner_stride_one = True

        def compiled(timestep):
            lbm = LBMConfig(streaming_pattern=self.pattern, timestep=timestep, **method)
            rule = create_lb_update_rule(lbm_config=lbm, lbm_optimisation=optimisation)
            return pystencils.create_kernel(rule, config).compile()

        self._arrays = [data.cpu_arrays[field.name] for field in fields]
        if self.pattern == "pull":
            step = compiled(Timestep.BOTH)
            a, b = self._arrays
            self._two_steps = lambda: (step(src=a, dst=b), step(src=b, dst=a))
        else:
            even, odd = compiled(Timestep.EVEN), compiled(Timestep.ODD)
            (a,) = self._arrays
            self._two_steps = lambda: (even(src=a), odd(src=a))
        self._fill(create_lb_method(LBMConfig(**method)).weights)
        self.seconds_to_build = time.perf_counter() - start
        self.bytes_per_node = sum(array.nbytes for array in self._arrays) / self._nodes

    def _fill(self, weights):
        """A fluid at rest, its density 1.01 to 1.011 at random: populations are deviations from the
        weights, and none is 0, so that every page is one of its own."""
        random = numpy.random.default_rng(20)
        for array in self._arrays:
            for i, weight in enumerate(weights):
                noise = random.random(array.shape[:3], dtype=array.dtype)
                array[..., i] = float(weight) * (0.01 + 0.001 * noise)

    def read(self, steps):
        """10^6 node updates a second, of blocks of four steps, after two blocks of warm-up."""
        self._block(), self._block()
        mlups = [self._block() for _ in range(max(1, -(-steps // BLOCK)))]
        sample = self._arrays[0][1:-1:50, 1:-1, 1:-1]
        if not (numpy.isfinite(sample).all() and 1e-5 < abs(sample).max() < 0.1):
            raise SystemExit(f"{self.form} blew up or died away: {abs(sample).max()}")
        return {
            "mlupsMedian": statistics.median(mlups),
            "mlupsBest": max(mlups),
            "mlups": mlups,
        }

    def _block(self):
        start = time.perf_counter()
        for _ in range(BLOCK // 2):
            self._two_steps()
        return BLOCK * self._nodes / (time.perf_counter() - start) / 1e6
