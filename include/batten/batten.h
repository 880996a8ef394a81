#ifndef BATTEN_BATTEN_H
#define BATTEN_BATTEN_H
/**
 * @file
 * Everything of libbatten. Two libraries have headers of their own: libbatten-picture
 * <batten/picture.h>, libbatten-design <batten/design.h>.
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
#include <batten/interpolate.h>
#include <batten/invariants.h>
#include <batten/local.h>
#include <batten/measure.h>
#include <batten/mesh.h>
#include <batten/model.h>
#include <batten/nearest.h>
#include <batten/offset.h>
#include <batten/offset_table.h>
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
