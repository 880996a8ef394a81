/* The output 'measure': a report: lengths, areas, volumes, boxes, moments and special
 * points of shapes. */
#include "base/plural.h"
#include "design/shared/rows.h"
#include "design/shared/solids.h"
#include "numeric/box.h"
#include <batten/measure.h>
#include <batten/text.h>

#include <math.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"measure", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "curves, surfaces, triangles, bodies, meshes; points and tables, which are counted"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "ends that are nearer close a curve; the tolerance, at most 1/1000 of its box, by "
     "default"},
    {"all", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "list more than ten special places of a curve, too; JSON always lists all"},
};

/* Of longer lists the text states the count and the ends, of extrema the sharpest. */
#define LIST_PLACES 10

typedef enum { INFLECTIONS, FLAT_POINTS, EXTREMA, STANDSTILLS, CROSSINGS, LISTS } list;

static const struct {
    const char *key, *text;
    batten_status (*find)(const batten_curve *curve, batten_parameters *out);
    bool plane; /* of plane curves only */
} lists[LISTS] = {
    {"inflections", "inflections", batten_curve_inflections, true},
    {"flat_points", "curvature is 0", batten_curve_flat_points, false},
    {"curvature_extrema", "extrema of curvature", batten_curve_curvature_extrema, false},
    {"standstills", "stands still", batten_curve_standstills, false},
    {"self_crossings", "crosses itself", batten_curve_self_crossings, true},
};

/* What is reported of one curve. */
typedef struct {
    const char *name;
    int axis; /* across its plane; 2 for xy; -1: in space */
    bool closed, encloses, turns;
    double length, error, gap; /* between the ends */
    batten_box box;
    batten_oriented_box oriented;
    batten_region region;
    double centroid[3], turning;
    batten_parameters found[LISTS];
    double sharpest[LIST_PLACES]; /* extrema of the largest curvature, which comes first */
} facts;

static void facts_end(facts *f)
{
    for (int k = 0; k < LISTS; k++)
        batten_release(f->found[k].at);
}

/* ---- measuring ---- */

static batten_status measure_gap(const batten_curve *curve, double *gap)
{
    const batten_interval domain = batten_curve_domain(curve);
    double a[3] = {0}, b[3] = {0};
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, a);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, domain.b, 0, b);
    *gap = bat_hypot(bat_hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
    return status;
}

static batten_status measure_plane(const batten_curve *flat, double within, facts *f)
{
    batten_status status = batten_curve_turning(flat, within, &f->turning);
    f->turns = status == BATTEN_OK;
    if (status == BATTEN_SINGULAR_HERE)
        status = BATTEN_OK;
    if (status != BATTEN_OK || !f->closed)
        return status;
    /* Relative to the square of the size: all digits that the report shows. */
    status = batten_curve_region(flat, within, 1e-12, &f->region);
    f->encloses = status == BATTEN_OK;
    return status == BATTEN_COINCIDENT ? BATTEN_OK : status;
}

/* Of the extrema those of the largest curvature, which the text states of a long list. */
static batten_status find_sharpest(const batten_curve *curve, facts *f)
{
    const batten_parameters *all = &f->found[EXTREMA];
    double sharp[LIST_PLACES];
    batten_status status = BATTEN_OK;
    for (int i = 0, kept = 0; i < all->count && status == BATTEN_OK; i++) {
        batten_curve_local local = {0};
        status = batten_curve_local_at(curve, all->at[i], BATTEN_FROM_RIGHT, &local);
        /* At a cusp curvature has no bound. */
        const double k = status == BATTEN_OK ? fabs(local.curvature) : HUGE_VAL;
        status = status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
        int at = kept < LIST_PLACES ? kept++ : LIST_PLACES;
        for (; at > 0 && sharp[at - 1] < k; at--)
            if (at < LIST_PLACES) {
                sharp[at] = sharp[at - 1];
                f->sharpest[at] = f->sharpest[at - 1];
            }
        if (at < LIST_PLACES) {
            sharp[at] = k;
            f->sharpest[at] = all->at[i];
        }
    }
    return status;
}

static batten_status find_places(const batten_curve *flat, facts *f)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < LISTS; k++)
        if (!lists[k].plane || batten_curve_dimension(flat) == 2)
            status = lists[k].find(flat, &f->found[k]);
    return status == BATTEN_OK ? find_sharpest(flat, f) : status;
}

/* The centroid where the curve is, in space. */
static void place_centroid(const batten_curve *curve, facts *f)
{
    const double *points = batten_curve_points(curve);
    for (int k = 0, j = 0; k < 3; k++)
        if (k != f->axis)
            f->centroid[k] = f->region.centroid[j++];
        else if (batten_curve_dimension(curve) == 3)
            f->centroid[k] = points[k];
}

static batten_status measure_measure(const batten_object *object, double within, facts *f)
{
    const batten_curve *curve = object->curve;
    batten_curve *flat = NULL;
    *f = (facts){.name = object->name, .closed = batten_curve_is_closed(curve, within)};
    batten_status status = batten_curve_flatten(curve, &f->axis, &flat);
    if (status == BATTEN_OK && batten_curve_dimension(curve) == 2)
        f->axis = 2;
    if (status == BATTEN_OK)
        /* As exact as rounding allows: the error that was reached is reported. */
        status = batten_curve_length(curve, 1e-12 * within, &f->error, &f->length);
    if (status == BATTEN_OK)
        status = measure_gap(curve, &f->gap);
    if (status == BATTEN_OK)
        status = batten_curve_bounds(curve, &f->box);
    if (status == BATTEN_OK)
        status = batten_curve_oriented_box(curve, within, &f->oriented);
    if (status == BATTEN_OK)
        status = find_places(flat, f);
    if (status == BATTEN_OK && batten_curve_dimension(flat) == 2)
        status = measure_plane(flat, within, f);
    if (status == BATTEN_OK && f->encloses)
        place_centroid(curve, f);
    batten_curve_unref(flat);
    return status;
}

/* ---- text ---- */

static void text_numbers(batten_text *out, const char *name, int count, const double *values)
{
    batten_text_add(out, "%s", name);
    for (int k = 0; k < count; k++)
        batten_text_add(out, " %.9g", values[k]);
}

static const char *plane_name(int axis)
{
    static const char *const names[] = {"yz", "xz", "xy"};
    return names[axis];
}

static void text_region(batten_text *out, const facts *f)
{
    const batten_region *r = &f->region;
    const double moments[3] = {r->xx, r->xy, r->yy};
    const double degrees = r->angle * (180 / BAT_PI);
    batten_text_add(out, "  area %.9g in the %s-plane", r->area, plane_name(f->axis));
    text_numbers(out, ", centroid", 3, f->centroid);
    text_numbers(out, "\n  second moments about it", 3, moments);
    text_numbers(out, ", principal", 2, r->principal);
    batten_text_add(out, " at %.9g degree%s\n", degrees, bat_plural_real(degrees, 9));
}

/* Why there is no area; ends that nearly meet may be meant to. */
static void text_open(batten_text *out, const facts *f)
{
    batten_text_add(out, "  no area: open by %.9g", f->gap);
    if (f->gap < f->length / 20)
        batten_text_add(out, "; 'within' (--within), when it is more, closes it");
    batten_text_add(out, "\n");
}

/* The places of a list; of a long one how many there are, and the sharpest or its ends. */
static void text_places(batten_text *out, const char *what, const batten_parameters *found,
                        const double *sharpest, bool all)
{
    const bool is_long = !all && found->count > LIST_PLACES;
    const int half = LIST_PLACES / 2;
    if (!is_long) {
        batten_text_add(out, "  %s at", what);
        text_numbers(out, "", found->count, found->at);
        batten_text_add(out, "\n");
        return;
    }
    batten_text_add(out, "  %s at %d places,", what, found->count);
    text_numbers(out, sharpest ? " the sharpest" : "", sharpest ? LIST_PLACES : half,
                 sharpest ? sharpest : found->at);
    if (!sharpest)
        text_numbers(out, " ...", half, found->at + found->count - half);
    batten_text_add(out, "; 'all' (--all) lists them\n");
}

static void text_curve(batten_text *out, const facts *f, bool all)
{
    const batten_vec3 low = f->box.low, high = f->box.high, c = f->oriented.centre;
    const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
    const double *half = f->oriented.half, centre[3] = {c.x, c.y, c.z};
    batten_text_add(out, "%s: %s", f->name, f->closed ? "closed, " : "");
    batten_text_add(out, "length %.9g", f->length);
    text_numbers(out, "\n  box", 3, from);
    text_numbers(out, "  to ", 3, to);
    batten_text_add(out, "\n  a small box at an angle: %.9g x %.9g x %.9g", 2 * half[0],
                    2 * half[1], 2 * half[2]);
    text_numbers(out, " about", 3, centre);
    batten_text_add(out, "\n");
    if (f->encloses)
        text_region(out, f);
    else if (!f->closed && f->axis >= 0)
        text_open(out, f);
    if (f->turns)
        batten_text_add(out, "  turning number %.9g\n", f->turning);
    for (int k = 0; k < LISTS; k++)
        if (f->found[k].count)
            text_places(out, lists[k].text, &f->found[k], k == EXTREMA ? f->sharpest : NULL,
                        all);
}

/* ---- JSON ---- */

static void json_numbers(batten_text *out, const char *key, int count, const double *values)
{
    batten_text_add(out, ", \"%s\": [", key);
    for (int k = 0; k < count; k++) {
        batten_text_add(out, k ? ", " : "");
        batten_text_number(out, values[k]);
    }
    batten_text_add(out, "]");
}

static void json_number(batten_text *out, const char *key, double value)
{
    batten_text_add(out, ", \"%s\": ", key);
    batten_text_number(out, value);
}

static void json_vector(batten_text *out, batten_vec3 v)
{
    const double values[3] = {v.x, v.y, v.z};
    for (int k = 0; k < 3; k++) {
        batten_text_add(out, k ? ", " : "[");
        batten_text_number(out, values[k]);
    }
    batten_text_add(out, "]");
}

static void json_box(batten_text *out, const batten_box *box)
{
    batten_text_add(out, ", \"box\": [");
    json_vector(out, box->low);
    batten_text_add(out, ", ");
    json_vector(out, box->high);
    batten_text_add(out, "]");
}

static void json_axes(batten_text *out, const batten_vec3 axes[3])
{
    for (int k = 0; k < 3; k++) {
        batten_text_add(out, k ? ", " : "");
        json_vector(out, axes[k]);
    }
}

static void json_boxes(batten_text *out, const facts *f)
{
    json_box(out, &f->box);
    batten_text_add(out, ", \"oriented_box\": {\"centre\": ");
    json_vector(out, f->oriented.centre);
    batten_text_add(out, ", \"axes\": [");
    json_axes(out, f->oriented.axes);
    batten_text_add(out, "]");
    json_numbers(out, "half", 3, f->oriented.half);
    batten_text_add(out, "}");
}

static void json_region(batten_text *out, const facts *f)
{
    const batten_region *r = &f->region;
    batten_text_add(out, ", \"plane\": \"%s\"", plane_name(f->axis));
    json_number(out, "area", r->area);
    json_numbers(out, "centroid", 3, f->centroid);
    json_numbers(out, "moments", 3, (const double[3]){r->xx, r->xy, r->yy});
    json_numbers(out, "principal", 2, r->principal);
    json_number(out, "angle", r->angle);
}

static void json_curve(batten_text *out, const facts *f)
{
    batten_text_add(out, "    {\"name\": ");
    batten_text_json(out, f->name);
    batten_text_add(out, ", \"type\": \"curve\", \"closed\": %s", f->closed ? "true" : "false");
    json_number(out, "length", f->length);
    json_number(out, "error", f->error);
    json_number(out, "gap", f->gap);
    json_boxes(out, f);
    if (f->encloses)
        json_region(out, f);
    if (f->turns)
        json_number(out, "turning", f->turning);
    for (int k = 0; k < LISTS; k++)
        if (!lists[k].plane || f->axis >= 0)
            json_numbers(out, lists[k].key, f->found[k].count, f->found[k].at);
    batten_text_add(out, "}");
}

/* ---- surfaces ---- */

/* Of integrals over surfaces. */
static const double precision = 1e-10;

/* What is reported of a surface, or of triangles, which are measured as patches with a pole. */
typedef struct {
    double area, error;
    batten_box box;
    double box_error; /* how far its sides may be from the surface */
} extent;

/* A fold, where halving does not converge, shows in the error. */
static batten_status add_area(const bat_run *run, const batten_surface *surface, extent *e)
{
    batten_area_measures found = {0};
    batten_status status = batten_surface_area(surface, precision, run->job, &found);
    if (status == BATTEN_TOLERANCE_NOT_MET)
        status = BATTEN_OK;
    e->area += found.area;
    e->error += found.error;
    return status;
}

static batten_status add_bounds(const batten_surface *surface, bool first, extent *e)
{
    const batten_box b = batten_surface_box(surface);
    const double size = bat_box_diagonal(b);
    batten_box box;
    double error = 0;
    const batten_status status =
        /* The box is exact to a thousand-millionth of the surface. */
        batten_surface_bounds(surface, size > 0 ? 1e-9 * size : 1, &error, &box);
    if (status != BATTEN_OK)
        return status;
    if (first)
        e->box = box;
    bat_box_join(&e->box, box);
    e->box_error = fmax(e->box_error, error);
    return BATTEN_OK;
}

static batten_status measure_extent(const bat_run *run, const batten_object *object, extent *e)
{
    batten_model *one = NULL, *patches = NULL;
    *e = (extent){.area = 0};
    batten_status status = batten_model_create(bat_unit_metres(run), &one);
    if (status == BATTEN_OK)
        status = batten_model_add(one, object);
    if (status == BATTEN_OK)
        status = batten_model_with_patches(one, BATTEN_PATCHES_POLE, &patches);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(patches); i++) {
        status = add_area(run, batten_model_object(patches, i)->surface, e);
        if (status == BATTEN_OK)
            status = add_bounds(batten_model_object(patches, i)->surface, i == 0, e);
    }
    batten_model_unref(patches);
    batten_model_unref(one);
    return status;
}

static void text_extent(batten_text *out, const char *name, const extent *e)
{
    const double from[3] = {e->box.low.x, e->box.low.y, e->box.low.z};
    const double to[3] = {e->box.high.x, e->box.high.y, e->box.high.z};
    batten_text_add(out, "%s: area %.9g", name, e->area);
    if (e->error > precision * e->area)
        batten_text_add(out, ", error at most %.3g", e->error);
    text_numbers(out, "\n  box", 3, from);
    text_numbers(out, "  to ", 3, to);
    if (e->box_error > 0)
        batten_text_add(out, " (error at most %.3g)", e->box_error);
    batten_text_add(out, "\n");
}

static void json_extent(batten_text *out, const batten_object *object, const extent *e)
{
    batten_text_add(out, "    {\"name\": ");
    batten_text_json(out, object->name);
    batten_text_add(out, ", \"type\": \"%s\"",
                    object->kind == BATTEN_OBJECT_SURFACE ? "surface" : "triangles");
    json_number(out, "area", e->area);
    json_number(out, "error", e->error);
    json_box(out, &e->box);
    json_number(out, "box_error", e->box_error);
    batten_text_add(out, "}");
}

static batten_status add_extent(const bat_run *run, const batten_object *object, bool json,
                                batten_text *out)
{
    extent e = {.area = 0};
    const batten_status status = measure_extent(run, object, &e);
    if (status == BATTEN_OK && json)
        json_extent(out, object, &e);
    else if (status == BATTEN_OK)
        text_extent(out, object->name, &e);
    return status;
}

/* ---- the report ---- */

/* A curve that is smaller than the tolerance is not closed for that. */
static double default_within(const bat_run *run, const batten_curve *curve)
{
    const batten_box b = batten_curve_box(curve);
    const double size = bat_box_diagonal(b);
    const double tolerance = bat_tolerance(run);
    return size > 0 ? bat_min(tolerance, size / 1000) : tolerance;
}

static batten_status add_curve(const bat_run *run, const batten_object *object, bool json,
                               batten_text *out)
{
    facts f;
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : default_within(run, object->curve);
    const batten_status status = measure_measure(object, within, &f);
    if (status == BATTEN_OK && json)
        json_curve(out, &f);
    else if (status == BATTEN_OK)
        text_curve(out, &f, bat_yes(run, "all"));
    facts_end(&f);
    return status;
}

static batten_status add_object(bat_run *run, const batten_object *object, bool json,
                                batten_text *out)
{
    batten_status status = BATTEN_OK;
    switch (object->kind) {
    case BATTEN_OBJECT_BODY:
    case BATTEN_OBJECT_MESH:
        status = bat_measure_solid(run, object, json, out);
        break;
    case BATTEN_OBJECT_CURVE:
        status = add_curve(run, object, json, out);
        break;
    case BATTEN_OBJECT_POINTS:
    case BATTEN_OBJECT_OFFSET_TABLE:
        bat_measure_points(object, json, out);
        break;
    default:
        status = add_extent(run, object, json, out);
    }
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY)
        return status;
    return bat_fail(status, "%s: %s", object->name, batten_message());
}

/* Once for all numbers: areas are in its square, volumes in its cube. */
static void begin_text(const bat_run *run, bool json, batten_text *text)
{
    const char *unit = bat_unit_name(run);
    if (json)
        batten_text_add(text, "{\n  \"unit\": \"%s\",\n  \"objects\": [\n", unit);
    else
        batten_text_add(text, "unit %s\n", *unit ? unit : "not stated");
}

static batten_status run_measure(bat_run *run)
{
    bat_objects objects;
    batten_text text = BATTEN_TEXT;
    const char *dot = strrchr(run->name, '.');
    const bool json = dot && strcmp(dot, ".json") == 0;
    batten_status status = bat_check_within(run);
    if (status == BATTEN_OK)
        status = bat_gather(run, "measure", BAT_ALL, &objects);
    if (status != BATTEN_OK)
        return status;
    begin_text(run, json, &text);
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++) {
        batten_text_add(&text, json && i ? ",\n" : "");
        status = add_object(run, objects.at[i], json, &text);
    }
    batten_text_add(&text, json ? "\n  ]\n}\n" : "");
    if (status == BATTEN_OK)
        status = batten_text_take(&text, &run->data, &run->size);
    batten_text_free(&text);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_measure = {
    .shown =
        {"measure",
         "A report: lengths, areas, volumes, boxes, moments and special points of shapes",
         "For each curve its length, the tight box, and a small box at an angle. Of one that is\n"
         "closed and lies in a plane x, y or z = constant: the area (clockwise negative), the\n"
         "centroid, the second moments about it (the integrals of x x, x y, y y in that plane)\n"
         "with their principal values, how often the tangent turns around. Then the parameters of\n"
         "inflections, of places where curvature is 0 or extreme, where the curve stands still\n"
         "(cusps) or crosses itself. All of them are found, except what the rounding of the\n"
         "control points hides. Of surfaces and triangles the area and the tight box. Of bodies\n"
         "the tight box, the area of the faces within their loops, the length of all edges and,\n"
         "when they close, the volume, with bounds of the errors; faces without closed loops are\n"
         "left out, with a note, and the command exits with 3. Of meshes those of the triangles,\n"
         "and why one does not close. Of points and tables of offsets their number and box. The\n"
         "unit of the lengths, that of the design, stands in the first line (\"unit\" in JSON);\n"
         "areas are in its square, volumes in its cube. As JSON, with all digits, when the file\n"
         "ends in .json.",
         "features:\n"
         "  oval: {ellipse: 2 m, b: 1 m}\n"
         "outputs:\n"
         "  oval.txt: {measure: oval}\n"
         "  oval.json: {measure: oval}\n",
         "[Toussaint83]", "batten_curve_region", BAT_PARAMETERS(parameters), true,
         .also =
             "length, area, volume, centroid, moments of inertia, curvature, inflections, bounding box"},
    .run = run_measure};
