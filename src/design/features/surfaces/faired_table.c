/* The feature 'faired-table': the table of offsets of what was lofted. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"faired-table", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "what was lofted"},
};

static batten_status run_faired_table(bat_run *run)
{
    const bat_item *item = bat_argument_of(run, "faired-table")->items;
    const batten_loft_report *loft = run->results[item->count].shown.loft;
    if (!loft)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%.60s' is not lofted, and has no faired table: name the feature with "
                        "'loft'",
                        item->text);
    const batten_object object = {.name = run->name,
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                  .offset_table = loft->faired};
    const batten_status status = bat_add(run, &object);
    if (status == BATTEN_OK)
        bat_remark(run, "its points are on the surface within %.2g", loft->faired_error);
    return status;
}

const bat_feature bat_feature_faired_table = {
    .shown =
        {"faired-table", "The table of offsets that a lofted hull has",
         "The table that was lofted, with the same stations and lines, as the surface has it: of a\n"
         "point on a waterline the half-breadth where the surface meets station and waterline, of a\n"
         "point on the keel, a knuckle or the sheer its half-breadth and height there, of others the\n"
         "nearest point in the plane of the station. A remark says how far its points are from the\n"
         "surface and these planes. 'corrections' lists what changed.",
         "features:\n"
         "  table: {read: offsets.csv}\n"
         "  hull: {loft: table, within: 3 mm}\n"
         "  faired: {faired-table: hull}\n"
         "outputs:\n"
         "  faired.csv: faired\n",
         "", "batten_hull_loft", BAT_PARAMETERS(parameters), false,
         .also = "faired offsets, table of offsets from a surface, read off, lofted offsets",
         .formula = "    (x_i, y, z_j) = S(u, v) on waterlines,  S(u, v) nearest to P in the plane x = x_i elsewhere",
         .promise = "Its points are on the surface, and in the planes of their stations, within the error that is remarked."},
    .run = run_faired_table};
