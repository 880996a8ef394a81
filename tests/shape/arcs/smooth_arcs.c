/* Rows of tangent arcs along whole curves. */
#include <batten/arcs.h>
#include <batten/standard.h>

#include "support/faults.h"

static const double pi = 3.14159265358979323846;

/* A search that went on without memory would give other arcs. @param[in,out] count  0: not known */
static batten_status make_arcs(const batten_curve *curve, int *count)
{
    batten_arcs_options options = batten_arcs_defaults();
    batten_chain *chain = NULL;
    options.tolerance = 0.1;
    options.joined = BATTEN_ARCS_SMOOTH;
    options.spread = false;
    const batten_status status = batten_arcs_from_curve(curve, &options, NULL, &chain);
    if (status == BATTEN_OK && *count == 0)
        *count = batten_chain_span_count(chain);
    if (status == BATTEN_OK)
        CHECK_INT(batten_chain_span_count(chain), *count);
    batten_chain_unref(chain);
    return status;
}

TEST(smooth_arcs_report_every_lack_of_memory)
{
    for (int closed = 0; closed < 2; closed++) {
        batten_curve *curve = NULL;
        int count = 0;
        CHECK_OK(batten_curve_ellipse(2, 1, 0, closed ? 2 * pi : 2, &curve));
        CHECK_OK(make_arcs(curve, &count));
        CHECK_ALL_ALLOCATIONS(make_arcs(curve, &count));
        batten_curve_unref(curve);
    }
}
