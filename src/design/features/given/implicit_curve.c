/* The feature 'implicit-curve': all of a curve given by one equation in the plane or two in space. */
#include "design/features/given/equations.h"

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"implicit-curve", BATTEN_VALUE_TEXT, true, true, NULL, NULL,
     "F(x, y) = G(x, y): in the plane; two equations in x, y and z: in space"},
    {"x", BATTEN_VALUE_RANGE, false, true, NULL, NULL, "the box"},
    {"y", BATTEN_VALUE_RANGE, false, true, NULL, NULL, "the box"},
    {"z", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "the box, in space"},
    BAT_EQUATION_WITHIN,
};

static batten_status put_points(bat_run *run, const batten_equation_curves *made)
{
    char name[220];
    if (made->point_count == 0)
        return BATTEN_OK;
    double *points = bat_array3((size_t)made->point_count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < made->point_count; i++) {
        points[3 * i] = made->points[i].point.x;
        points[3 * i + 1] = made->points[i].point.y;
        points[3 * i + 2] = made->points[i].point.z;
    }
    snprintf(name, sizeof name, "special points of %.190s", run->name);
    const batten_object object = {.name = name,
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_POINTS,
                                  .point_count = made->point_count,
                                  .points = points};
    const batten_status status = bat_add(run, &object);
    bat_release(points);
    return status;
}

static batten_status put_curves(bat_run *run, const batten_equation_curves *made)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < made->count && status == BATTEN_OK; i++) {
        batten_curve *curve = NULL;
        status = batten_curve_to_dimension(made->curves[i], 3, &curve);
        status = bat_put_curve(run, status, curve);
    }
    bat_report_error(run, made->error, made->error);
    bat_remark_points(run, made);
    return status == BATTEN_OK ? put_points(run, made) : status;
}

static batten_status find_box(const bat_run *run, int dimension, batten_box *box)
{
    static const char *const axes[] = {"x", "y", "z"};
    batten_interval range[3] = {{0, 0}, {0, 0}, {0, 0}};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < dimension && status == BATTEN_OK; k++)
        status = bat_equation_range(run, axes[k], &range[k]);
    *box = (batten_box){{range[0].a, range[1].a, range[2].a},
                        {range[0].b, range[1].b, range[2].b}};
    if (status == BATTEN_OK && dimension == 2 && bat_has(run, "z"))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "one equation is a curve of the plane, and a range of z has no use; a curve in "
            "space needs two equations [F, G]");
    return status;
}

static batten_status trace_curves(bat_run *run, int count, batten_equation *const *read)
{
    batten_equation_curves made = {0};
    batten_box box;
    batten_status status = find_box(run, count + 1, &box);
    if (status == BATTEN_OK)
        status = batten_curves_implicit(count, (const batten_equation *const *)read, &box,
                                        bat_equation_within(run), run->job, &made);
    if (status == BATTEN_INCOMPLETE && made.undecided_count > 0) {
        bat_note(run, "INCOMPLETE: %s", batten_message());
        status = BATTEN_OK;
    }
    if (status == BATTEN_OK && made.count + made.point_count == 0)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          made.undecided_count
                              ? "no part of the curve could be shown to be there"
                              : "the box has no point of the curve; that is proved");
    if (status == BATTEN_OK)
        status = put_curves(run, &made);
    batten_equation_curves_release(&made);
    return status;
}

static batten_status run_implicit_curve(bat_run *run)
{
    static const char *const variables[] = {"x", "y", "z"};
    const bat_argument *given = bat_argument_of(run, "implicit-curve");
    const int count = given->count;
    batten_equation *read[2] = {NULL, NULL};
    if (count > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d equations; a curve has one in the plane and two in space", count);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = bat_equation(run, given->items[i].text, count + 1, variables, &read[i]);
    if (status == BATTEN_OK)
        status = trace_curves(run, count, read);
    batten_equation_free(read[0]);
    batten_equation_free(read[1]);
    return status;
}

const bat_feature bat_feature_implicit_curve = {
    .shown =
        {"implicit-curve", "All of the curve F(x, y) = 0, or F = G = 0 in space, within a box",
         "The box is cut in two again and again; interval arithmetic proves of each part that the\n"
         "curve does not enter it, or that it is a graph over one axis there. So no branch and no\n"
         "loop is missed. Nodes, cusps and isolated points, where the gradient vanishes, are found\n"
         "to within the tolerance, and come as points. Curves and equation are nowhere farther\n"
         "apart than 'within', which is proved. Where branches touch, and along squares, the\n"
         "result is marked INCOMPLETE, with the number of boxes that are undecided.\n"
         "The curve is that of the box grown by at most the tolerance.\n\n" BAT_EQUATION_TEXT,
         "features:\n"
         "  oval: {implicit-curve: (x^2 + y^2)^2 = 2*(x^2 - y^2), x: [-2, 2], y: [-1, 1]}\n"
         "  window: {implicit-curve: [x^2 + y^2 + z^2 = 4, (x - 1)^2 + y^2 = 1],\n"
         "    x: [-2, 2], y: [-2, 2], z: [-2, 2]}\n",
         "[SW05] [Neumaier90]", "batten_curves_implicit", BAT_PARAMETERS(parameters), false,
         .also =
             "implicit plot, level set, algebraic curve, F(x, y) = 0, space curve of two equations, lemniscate, folium, Cassini oval",
         .formula = "    {(x, y): F(x, y) = 0},  {(x, y, z): F(x, y, z) = G(x, y, z) = 0}",
         .promise =
             "Every branch and loop in the box is there, within the error, which is proved; else it is INCOMPLETE."},
    .run = run_implicit_curve};
