/* 130: offset curves. */
#include "base/plural.h"
#include "exchange/iges/read/curves.h"

#include <batten/offset.h>
#include <string.h>

/* The offset goes along V x T, which is to the left of the curve seen against V. */
static batten_status offset(bat_iges_item *item, const batten_curve *base, double distance,
                            const double normal[3])
{
    batten_curve_offset_options options = batten_curve_offset_defaults();
    batten_curve_offset_report report;
    batten_curves made = {0, NULL};
    options.tolerance = bat_iges_tolerance(item->reading, bat_iges_size_of_curve(base));
    options.normal = (batten_vec3){normal[0], normal[1], normal[2]};
    options.loops = BATTEN_LOOPS_KEEP;
    options.most_pieces =
        bat_input_most_near(item->reading->input, batten_curve_point_count(base));
    batten_status status = batten_curve_offset(base, distance, &options, &report, &made);
    if (status == BATTEN_OK && made.count != 1)
        status = bat_fail(BATTEN_SINGULAR_HERE, "its offset by %g is %d curve%s", distance,
                          made.count, bat_plural(made.count));
    if (status == BATTEN_OK && report.error > 0)
        bat_iges_remark(item->reading, item->entry, "offset by %g within %g", distance,
                        report.error);
    if (status == BATTEN_OK)
        item->curve = batten_curve_ref(made.at[0]);
    batten_curves_release(&made);
    return status;
}

/* DE1, FLAG, DE2, NDIM, PTYPE, D1, TD1, D2, TD2, V, TT1, TT2. */
batten_status bat_iges_read_offset_curve(bat_iges_item *item)
{
    int id = 0, flag = 0;
    double d[4], normal[3], range[2];
    const batten_curve *base = NULL;
    batten_curve *part = NULL;
    batten_status status = bat_iges_integer(item->parameters, 1, &id);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 2, &flag);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item->parameters, 6, 4, d);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item->parameters, 10, 3, normal);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item->parameters, 13, 2, range);
    if (status == BATTEN_OK && flag != 1 && !(flag == 2 && d[0] == d[2]))
        status = bat_fail(BATTEN_UNSUPPORTED,
                          "its distance varies (flag %d), which is not read", flag);
    if (status == BATTEN_OK)
        status = bat_iges_curve(item->reading, id, &base);
    if (status != BATTEN_OK)
        return status;
    item->own = 15;
    const batten_interval domain = batten_curve_domain(base),
                          asked = bat_iges_interval(item, 13, domain);
    if (asked.a == domain.a && asked.b == domain.b)
        part = batten_curve_ref(base);
    else
        status = batten_curve_subrange(base, asked.a, asked.b, &part);
    if (status == BATTEN_OK)
        status = offset(item, part, d[0], normal);
    batten_curve_unref(part);
    return status;
}
