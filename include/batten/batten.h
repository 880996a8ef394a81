#ifndef BATTEN_BATTEN_H
#define BATTEN_BATTEN_H
/**
 * @file
 * Everything of libbatten. Pictures and designs have headers and libraries of their own.
 */
#include <batten/approximate.h>
#include <batten/arcs.h>
#include <batten/base.h>
#include <batten/beta.h>
#include <batten/biarc.h>
#include <batten/chain.h>
#include <batten/continuity.h>
#include <batten/cubic.h>
#include <batten/cubic_spline.h>
#include <batten/curve.h>
#include <batten/curve_offset.h>
#include <batten/divide.h>
#include <batten/energy.h>
#include <batten/exchange.h>
#include <batten/extend.h>
#include <batten/fair.h>
#include <batten/file.h>
#include <batten/fold.h>
#include <batten/gcode.h>
#include <batten/geometry.h>
#include <batten/inspect.h>
#include <batten/interpolate.h>
#include <batten/invariants.h>
#include <batten/job.h>
#include <batten/local.h>
#include <batten/model.h>
#include <batten/nonlinear.h>
#include <batten/notes.h>
#include <batten/number.h>
#include <batten/offsets.h>
#include <batten/polygon.h>
#include <batten/quadratic.h>
#include <batten/primitives.h>
#include <batten/skin.h>
#include <batten/standard.h>
#include <batten/surface.h>
#include <batten/tension.h>
#include <batten/text.h>
#include <batten/thin.h>
#include <batten/units.h>
#include <batten/weighted.h>
#endif
