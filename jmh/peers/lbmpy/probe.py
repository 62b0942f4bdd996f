"""The bandwidth that the memory has at this moment (probe.c)."""

import ctypes
import statistics


class Probe:
    """Two arrays that stay; a reading is five sweeps of each kind."""

    def __init__(self, library, gibibytes, threads):
        self._bytes = int(gibibytes * 2**30) // 8 * 8
        self._library = ctypes.CDLL(library)
        for sweep in (self._library.probe_in_place, self._library.probe_copy):
            sweep.restype = ctypes.c_double
            sweep.argtypes = [ctypes.c_double]
        if self._library.probe_open(ctypes.c_int64(self._bytes), threads):
            raise SystemExit(f"no memory for the probe: 2 x {gibibytes} GiB")
        self.read()  # the first one still pays for the pages

    def read(self):
        """GB/s, bytes read and bytes written counted, of every sweep and their medians."""
        factors = (1.25, 0.8, 1.25, 0.8, 1.0)  # the values stay what they are
        in_place = [16 * self._gbps(self._library.probe_in_place(f)) for f in factors]
        copy = [24 * self._gbps(self._library.probe_copy(f)) for f in factors]
        return {
            "inPlaceGBpsMedian": statistics.median(in_place),
            "copyGBpsMedian": statistics.median(copy),
            "inPlaceGBps": in_place,
            "copyGBps": copy,
        }

    def _gbps(self, seconds):
        """GB/s of one byte an element."""
        return self._bytes / 8 / seconds / 1e9
