/* The output 'affine-match': a report: is one curve the affine image of another, and by
 * which map?. */
#include "design/feature.h"
#include <batten/invariants.h>
#include <batten/text.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"affine-match", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "two curves or more; each is compared with the first"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far an image may be from its curve; the tolerance of the design by default"},
};

/* ---- text ---- */

/* Six digits are enough for people. */
static void text_term(batten_text *out, bool is_first, double value, const char *of)
{
    if (is_first)
        batten_text_add(out, " %.6g%s", value, of);
    else
        batten_text_add(out, " %s %.6g%s", value < 0 ? "-" : "+", fabs(value), of);
}

/* Does the map keep the plane z = 0, and what is above it there? */
static bool is_plane(const batten_affine *map)
{
    return map->m[0][2] == 0 && map->m[1][2] == 0 && map->m[2][0] == 0 && map->m[2][1] == 0 &&
           map->t[2] == 0;
}

static void text_map(batten_text *out, const batten_affine *map)
{
    static const char *const axes[] = {" x", " y", " z"};
    const int d = is_plane(map) ? 2 : 3;
    for (int i = 0; i < d; i++) {
        batten_text_add(out, " %s' =", axes[i]);
        for (int j = 0; j < d; j++)
            text_term(out, j == 0, map->m[i][j], axes[j]);
        text_term(out, false, map->t[i], "");
        batten_text_add(out, "\n");
    }
}

static void text_match(batten_text *out, const char *from, const char *to,
                       const batten_affine_match *m)
{
    if (!m->found) {
        batten_text_add(out, "%s: not an affine image of %s", to, from);
        if (isfinite(m->error))
            batten_text_add(out, "; the nearest found is %.3g away", m->error);
        batten_text_add(out, "\n");
        return;
    }
    batten_text_add(out, "%s: an affine image of %s, to %.3g%s\n", to, from, m->error,
                    m->is_whole ? ", of another part of the same curve" : "");
    text_map(out, &m->map);
    batten_text_add(out, "  parameter of %s =", from);
    text_term(out, true, m->c, " v");
    text_term(out, false, m->f, "");
    batten_text_add(out, "\n");
}

/* ---- JSON ---- */

static void json_numbers(batten_text *out, int count, const double *values)
{
    batten_text_add(out, "[");
    for (int k = 0; k < count; k++) {
        batten_text_add(out, k ? ", " : "");
        batten_text_number(out, values[k]);
    }
    batten_text_add(out, "]");
}

static void json_match(batten_text *out, const char *from, const char *to,
                       const batten_affine_match *m)
{
    batten_text_add(out, "    {\"from\": ");
    batten_text_json(out, from);
    batten_text_add(out, ", \"to\": ");
    batten_text_json(out, to);
    batten_text_add(out, ", \"found\": %s, \"error\": ", m->found ? "true" : "false");
    if (isfinite(m->error))
        batten_text_number(out, m->error);
    else
        batten_text_add(out, "null");
    if (m->found) {
        batten_text_add(out, ", \"whole\": %s, \"map\": [", m->is_whole ? "true" : "false");
        for (int i = 0; i < 3; i++) {
            batten_text_add(out, i ? ", " : "");
            json_numbers(out, 3, m->map.m[i]);
        }
        batten_text_add(out, "], \"offset\": ");
        json_numbers(out, 3, m->map.t);
        batten_text_add(out, ", \"c\": ");
        batten_text_number(out, m->c);
        batten_text_add(out, ", \"f\": ");
        batten_text_number(out, m->f);
    }
    batten_text_add(out, "}");
}

/* ---- the report ---- */

static batten_status compare(bat_run *run, const batten_object *from, const batten_object *to,
                             bool json, batten_text *out)
{
    batten_affine_match match;
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    const batten_status status =
        batten_curve_affine_match(from->curve, to->curve, within, &match);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    if (status != BATTEN_OK)
        return bat_fail(status, "%s and %s: %s", from->name, to->name, batten_message());
    if (bat_has(run, "within") && !match.found) {
        run->unmet = true;
        bat_note(run, "'%s' is not an affine image of '%s' within %g", to->name, from->name,
                 within);
    }
    if (json)
        json_match(out, from->name, to->name, &match);
    else
        text_match(out, from->name, to->name, &match);
    return BATTEN_OK;
}

static batten_status run_affine_match(bat_run *run)
{
    bat_objects objects;
    batten_text text = BATTEN_TEXT;
    const char *dot = strrchr(run->name, '.');
    const bool json = dot && strcmp(dot, ".json") == 0;
    batten_status status = bat_gather(run, "affine-match", BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    if (objects.count < 2)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "'affine-match' compares two curves or more, not %d", objects.count);
    if (json && status == BATTEN_OK)
        batten_text_add(&text, "{\n  \"matches\": [\n");
    for (int i = 1; i < objects.count && status == BATTEN_OK; i++) {
        if (json && i > 1)
            batten_text_add(&text, ",\n");
        status = compare(run, objects.at[0], objects.at[i], json, &text);
    }
    if (json && status == BATTEN_OK)
        batten_text_add(&text, "\n  ]\n}\n");
    if (status == BATTEN_OK)
        status = batten_text_take(&text, &run->data, &run->size);
    batten_text_free(&text);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_affine_match = {
    .shown =
        {"affine-match",
         "A report: is one curve the affine image of another, and by which map?",
         "For the second curve and each after it: the affine map that brings the first one there,\n"
         "the parameters that correspond, and how far the image is from the curve, a bound.\n"
         "Splines are compared end to end, in both directions; of single polynomials any two parts\n"
         "of one curve are found to be the same, whatever their degree and length, by their\n"
         "invariants ('classify' lists them as JSON). All parabolas are images of each other, and\n"
         "so are all cubics with a loop. With 'within' a curve that is not an image fails the\n"
         "check of the build. Rational curves are refused. As JSON, with all digits, when the file\n"
         "ends in .json.",
         "features:\n"
         "  corners: {points: [[0, 0], [1 m, 2 m], [3 m, 0], [4 m, 1 m], [5 m, 4 m]]}\n"
         "  frame: {bezier: corners}\n"
         "  other: {scale: frame, by: [2, 1, 1]}\n"
         "outputs:\n"
         "  same.txt: {affine-match: [frame, other], within: 1 um}\n",
         "[SL section VIII.3] [SL section VIII.4] [SuXin80]", "batten_curve_affine_match",
         BAT_PARAMETERS(parameters), true,
         .also = "affine equivalence, same curve up to an affine map"},
    .run = run_affine_match};
