#include "design/examples.h"

QUIET_EXAMPLE(collect, "collect")
EXAMPLE(contours, "contours")
QUIET_EXAMPLE(curve_of, "curve-of")
QUIET_EXAMPLE(divide, "divide")
QUIET_EXAMPLE(edges, "edges")
QUIET_EXAMPLE(frames, "frames")
EXAMPLE(mesh, "mesh")
QUIET_EXAMPLE(part, "part")
QUIET_EXAMPLE(select, "select")
