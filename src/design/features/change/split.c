/* The feature 'split': both parts of what is cut at a parameter, or all pieces of one
 * kind. */
#include "design/features/take/pieces.h"
#include "design/shared/rows.h"

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"split", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"parameter", BATTEN_VALUE_NUMBER, false, false, NULL, NULL, "where they are cut"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
    BAT_PIECES_PARAMETERS,
};

batten_status bat_pieces_divide(const bat_run *run, const batten_object *object,
                                batten_parameters *out)
{
    const batten_piece_kind kind = (batten_piece_kind)bat_word(run, "pieces");
    batten_vec3 along = {0, 0, 0};
    const bool has_direction = bat_has(run, "along");
    if (has_direction && kind != BATTEN_PIECES_MONOTONE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'along' is for monotone pieces");
    if (has_direction)
        along = bat_point(run, "along");
    const bool bends = kind == BATTEN_PIECES_SPIRAL || kind == BATTEN_PIECES_CONVEX;
    batten_curve *flat = NULL;
    int axis;
    batten_status status = BATTEN_OK;
    if (bends)
        status = batten_curve_flatten(object->curve, &axis, &flat);
    if (status == BATTEN_OK)
        status = batten_curve_divide_pieces(bends ? flat : object->curve, kind,
                                            has_direction ? &along : NULL, out);
    batten_curve_unref(flat);
    return status == BATTEN_OK ? status
                               : bat_fail(status, "%s: %s", object->name, batten_message());
}

static batten_status split_in_pieces(bat_run *run, const batten_object *object)
{
    batten_parameters at = {0, NULL};
    batten_status status = bat_pieces_divide(run, object, &at);
    for (int i = 0; status == BATTEN_OK && i + 1 < at.count; i++) {
        batten_curve *part = NULL;
        batten_chain *chain = NULL;
        batten_object like = *object;
        char name[220];
        snprintf(name, sizeof name, "%.200s %d", object->name, i + 1);
        if (at.count > 2)
            like.name = name;
        status = batten_curve_subrange(object->curve, at.at[i], at.at[i + 1], &part);
        if (status == BATTEN_OK && object->chain)
            status = batten_chain_subrange(object->chain, at.at[i], at.at[i + 1], &chain);
        status = bat_put_chain_like(run, status, part, chain, &like);
    }
    bat_release(at.at);
    return status;
}

/* The halves of what a curve truly is, when that is a chain. */
static batten_status split_chain(const batten_chain *chain, double at, batten_chain *halves[2])
{
    const batten_interval domain = batten_chain_domain(chain);
    const batten_status status = batten_chain_subrange(chain, domain.a, at, &halves[0]);
    return status == BATTEN_OK ? batten_chain_subrange(chain, at, domain.b, &halves[1])
                               : status;
}

static batten_status split_object(bat_run *run, const batten_object *object)
{
    batten_curve *curves[2] = {NULL, NULL};
    batten_chain *chains[2] = {NULL, NULL};
    batten_surface *surfaces[2] = {NULL, NULL};
    const double at = bat_number(run, "parameter");
    const bool is_curve = object->kind == BATTEN_OBJECT_CURVE;
    batten_status status =
        is_curve ? batten_curve_split(object->curve, at, &curves[0], &curves[1])
                 : batten_surface_split(object->surface,
                                        (batten_direction)bat_word(run, "direction"), at,
                                        &surfaces[0], &surfaces[1]);
    if (status == BATTEN_OK && object->chain)
        status = split_chain(object->chain, at, chains);
    for (int i = 0; i < 2; i++) {
        batten_object half = *object;
        char name[220];
        snprintf(name, sizeof name, "%.200s %d", object->name, i + 1);
        half.name = name;
        status = is_curve ? bat_put_chain_like(run, status, curves[i], chains[i], &half)
                          : bat_put_surface_like(run, status, surfaces[i], &half);
    }
    return status;
}

static batten_status run_split(bat_run *run)
{
    bat_objects objects;
    const bool pieces = bat_has(run, "pieces");
    if (bat_has(run, "parameter") == pieces)
        return bat_fail(BATTEN_BAD_ARGUMENT, "either 'parameter' or 'pieces' must be given");
    batten_status status =
        bat_gather(run, "split", pieces ? BAT_CURVES : BAT_CURVES | BAT_SURFACES, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status =
            pieces ? split_in_pieces(run, objects.at[i]) : split_object(run, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_split = {
    .shown =
        {"split", "Both parts of what is cut at a parameter, or all pieces of one kind",
         "Exact; the parts of 'keel' are named 'keel 1' and 'keel 2' and keep their parameters.\n"
         "Instead of a parameter 'pieces' says what the parts of curves are: 'monotone' ones rise\n"
         "or fall in each coordinate (or 'along' one direction), 'spiral' ones have curvature that\n"
         "rises or falls and keeps its sign, without corners or jumps, 'convex' ones bend one way\n"
         "in the plane and turn by half a turn at most, 'spans' lie between knots. Each piece is\n"
         "checked again afterwards.",
         "features:\n"
         "  keel: {line: [[0, 0], [3 m, 0]]}\n"
         "  halves: {split: keel, parameter: 0.5}\n"
         "  oval: {ellipse: 2 m, b: 1 m}\n"
         "  quarters: {split: oval, pieces: spiral}\n",
         "[PT97 section 5.2]", "batten_curve_split", BAT_PARAMETERS(parameters), false,
         .also = "subdivide, cut in two, de Casteljau, monotone pieces, spans"},
    .run = run_split,
    .cuts = true};
