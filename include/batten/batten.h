#ifndef BATTEN_BATTEN_H
#define BATTEN_BATTEN_H
/**
 * @file
 * Everything of libbatten. Two libraries have headers of their own: libbatten-picture
 * <batten/picture.h>, libbatten-design <batten/design.h>.
 *
 * What holds for all of it:
 *
 * - A call that fails leaves its outputs as they were. What may be filled in all the same, its
 *   type says: a struct named `..._report` or `..._measures` tells how far the call came. Where
 *   that happens, the function says with which statuses.
 * - Options are structs that begin with their own `size`, which their defaults set. New fields
 *   are added at the end only. A program that was compiled when the struct was shorter keeps
 *   working: it gets the defaults for what it does not know. A struct longer than the library's,
 *   from a newer header, is BATTEN_BAD_ARGUMENT, as is a size that nobody set; so always start
 *   from the defaults:
 *
 *       batten_mesh_options options = batten_mesh_defaults();
 *       options.angle = 0.1;
 *
 *   NULL instead of options asks for the defaults, where some make sense. The same holds for a
 *   batten_job, which starts from BATTEN_JOB, and for options inside options.
 */
#include <batten/approximate.h>
#include <batten/arcs.h>
#include <batten/base.h>
#include <batten/bent.h>
#include <batten/blend.h>
#include <batten/body.h>
#include <batten/chain.h>
#include <batten/continuity.h>
#include <batten/contours.h>
#include <batten/coons.h>
#include <batten/curvature.h>
#include <batten/curve.h>
#include <batten/exchange.h>
#include <batten/extend.h>
#include <batten/fair.h>
#include <batten/fill.h>
#include <batten/geometry.h>
#include <batten/gordon.h>
#include <batten/grid.h>
#include <batten/hull.h>
#include <batten/interpolate.h>
#include <batten/invariants.h>
#include <batten/local.h>
#include <batten/measure.h>
#include <batten/mesh.h>
#include <batten/model.h>
#include <batten/nearest.h>
#include <batten/offset.h>
#include <batten/plate.h>
#include <batten/polygon.h>
#include <batten/scattered.h>
#include <batten/skin.h>
#include <batten/standard.h>
#include <batten/surface.h>
#include <batten/sweep.h>
#include <batten/text.h>
#include <batten/triangles.h>
#endif
