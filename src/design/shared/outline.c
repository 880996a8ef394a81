/* Joins curves to one, piece by piece. */
#include "design/shared/outline.h"

batten_status bat_outline_add(batten_status status, double tolerance, batten_curve *piece,
                              batten_curve **outline)
{
    batten_curve *joined = NULL;
    if (status == BATTEN_OK && *outline)
        status = batten_curve_join(*outline, piece, tolerance, &joined);
    else if (status == BATTEN_OK)
        joined = batten_curve_ref(piece);
    if (status == BATTEN_OK) {
        batten_curve_unref(*outline);
        *outline = joined;
    }
    batten_curve_unref(piece);
    return status;
}
