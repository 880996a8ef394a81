/* The feature 'skin': the surface through sections. */
#include "base/plural.h"
#include "design/shared/folds.h"
#include "design/shared/place.h"
#include "design/shared/sweeps.h"

static const batten_parameter parameters[] = {
    {"skin", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the sections, in order; the first and the last may be a point"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the sections"},
    {"within", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "how far a section may move for the sake of few knots; 0 keeps all knots"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the sections"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds at both ends"},
    {"start", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS,
     "what holds at the first section"},
    {"start-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative or direction there"},
    {"end", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS,
     "what holds at the last section"},
    {"end-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative or direction there"},
    {"periodic", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first section follows the last"},
    {"align", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "reverse or turn sections that would twist the surface; no keeps them"},
    {"poles", BATTEN_VALUE_WORD, false, false, "sharp", "sharp smooth",
     "what the surface is at a section that is a point"},
    {"spine", BATTEN_VALUE_MODEL, false, false, NULL, NULL,
     "a curve along which the sections, drawn in the xy-plane, are placed"},
    {"twist", BATTEN_VALUE_ANGLE, true, false, NULL, NULL, "of each section about the spine"},
    {"scale", BATTEN_VALUE_NUMBER, true, false, NULL, NULL, "of each section"},
    {"frames", BATTEN_VALUE_WORD, false, false, "rotation-minimising",
     "rotation-minimising fixed frenet closing", "how the sections turn along the spine"},
    {"turn", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "closed sections start where they are nearest to the one before"},
    {"starts", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "where each closed section starts: a share of its parameter, 0 to 1"},
    {"match", BATTEN_VALUE_WORD, false, false, "parameters", "parameters arc-length marks",
     "which points of the sections belong together"},
    {"marks", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "as many for each section, one section after another: shares of its parameter"},
    {"creases", BATTEN_VALUE_WORD, false, false, "within", "within cure keep",
     "where no section has a corner: cured when 'within' is given; always, exactly; kept"},
    {"procedural", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "blend the sections as they are; the NURBS is made within the design's tolerance"},
};

/* ---- arguments ---- */

/* One number for each section, or NULL where none is given. */
static batten_status list_numbers(const bat_run *run, const char *parameter, int count,
                                  double **out)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    *out = NULL;
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d value%s for %d section%s", parameter,
                        given->count, bat_plural(given->count), count, bat_plural(count));
    *out = bat_array((size_t)count, sizeof **out);
    for (int i = 0; *out && i < count; i++)
        (*out)[i] = given->items[i].number[0];
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* From shares of the parameter of each section to parameters; `each` for every section. */
static void shares_to_parameters(int count, int each, const batten_curve **sections,
                                 double *values)
{
    for (int i = 0; i < count * each; i++) {
        const batten_interval domain = batten_curve_domain(sections[i / each]);
        values[i] = (1 - values[i]) * domain.a + values[i] * domain.b;
    }
}

/* The lists of numbers; the owner releases them, after a failure too. */
typedef struct {
    double *twist, *scale, *starts, *marks;
} lists;

static batten_status list_marks(const bat_run *run, int count, const batten_curve **sections,
                                batten_surface_skin_options *options, lists *out)
{
    const int given = bat_argument_of(run, "marks")->count;
    if (given == 0)
        return BATTEN_OK;
    if (given % count)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'marks' has %d value%s, not as many for each of %d sections", given,
                        bat_plural(given), count);
    options->mark_count = given / count;
    const batten_status status = list_numbers(run, "marks", given, &out->marks);
    if (status == BATTEN_OK)
        shares_to_parameters(count, options->mark_count, sections, out->marks);
    options->marks = out->marks;
    return status;
}

static batten_status make_lists(const bat_run *run, int count, const batten_curve **sections,
                                batten_surface_skin_options *options, lists *out)
{
    batten_status status = list_numbers(run, "twist", count, &out->twist);
    if (status == BATTEN_OK)
        status = list_numbers(run, "scale", count, &out->scale);
    if (status == BATTEN_OK)
        status = list_numbers(run, "starts", count, &out->starts);
    if (status == BATTEN_OK && out->starts)
        shares_to_parameters(count, 1, sections, out->starts);
    if (status == BATTEN_OK)
        status = list_marks(run, count, sections, options, out);
    options->twist = out->twist;
    options->scale = out->scale;
    options->starts = out->starts;
    return status;
}

static void release_lists(lists *l)
{
    bat_release(l->twist);
    bat_release(l->scale);
    bat_release(l->starts);
    bat_release(l->marks);
}

static void read_options(const bat_run *run, batten_surface_skin_options *options)
{
    *options = batten_surface_skin_defaults();
    options->degree = bat_count(run, "degree");
    options->tolerance = bat_number(run, "within");
    options->parameters = (batten_parametrization)bat_word(run, "parameters");
    options->start = bat_end(run, "start", "start-vector");
    options->end = bat_end(run, "end", "end-vector");
    options->closed = bat_yes(run, "periodic");
    /* Marks belong to sections as they run. */
    options->align = bat_yes(run, "align") &&
                     (bat_argument_of(run, "align")->given || !bat_has(run, "marks"));
    options->untwist = options->align;
    options->smooth_poles = bat_word(run, "poles") == 1;
    options->frames = (batten_frame_kind)bat_word(run, "frames");
    options->turn = bat_yes(run, "turn");
    options->match = (batten_skin_match)bat_word(run, "match");
    options->creases = (batten_skin_creases)bat_word(run, "creases");
}

/* ---- notes ---- */

static void report_skin(const bat_run *run, const batten_surface_skin_report *found)
{
    static const char *const cures[] = {
        "", "spans of sections were stretched so that their speed does not jump",
        "weights of sections were rescaled so that they do not jump",
        "rational sections became polynomial, for their weights jump"};
    if (found->reversed_count > 0)
        bat_remark(
            run, "%d section%s reversed, the first of them section %d", found->reversed_count,
            bat_one_or_many(found->reversed_count, " was", "s were"), found->reversed + 1);
    if (found->turned_count > 0)
        bat_remark(
            run, "%d section%s elsewhere, the first of them section %d", found->turned_count,
            bat_one_or_many(found->turned_count, " starts", "s start"), found->turned + 1);
    if ((found->reversed_count > 0 || found->turned_count > 0) &&
        !bat_argument_of(run, "align")->given)
        bat_remark(run, "'align: no' keeps sections as they are");
    if (found->crossing_count > 0)
        bat_note(run, "section %d crosses the next, as do %d in all: the surface folds there",
                 found->crossing + 1, found->crossing_count);
    if (found->disorder_count > 0)
        bat_note(run, "sections %d and %d seem to be in the wrong order; %d pair%s",
                 found->disorder + 1, found->disorder + 2, found->disorder_count,
                 bat_one_or_many(found->disorder_count, " does", "s do"));
    if (found->cure != BATTEN_CURE_NONE)
        bat_remark(run, "%s", cures[found->cure]);
    /* Less than a ten-thousandth of a radian is not seen, and comes from rounding in files. */
    if (found->crease > 1e-4)
        bat_note(run, "the surface has a crease of %.3g degree%s that no section has; %s",
                 found->crease * 90 / bat_acos(0),
                 bat_plural_real(found->crease * 90 / bat_acos(0), 3),
                 bat_has(run, "within") ? "a smaller 'within' makes it less"
                                        : "'creases: cure' or 'within' may cure it");
}

static batten_status skin(bat_run *run, int count, const batten_curve **sections)
{
    batten_surface_skin_options options;
    batten_surface *surface = NULL;
    lists given = {0};
    read_options(run, &options);
    batten_status status =
        bat_has(run, "spine") ? bat_one_curve(run, "spine", &options.spine) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = make_lists(run, count, sections, &options, &given);
    if (status == BATTEN_OK && bat_yes(run, "procedural"))
        status = batten_surface_skin_procedural((batten_curve_row){count, sections}, &options,
                                                NULL, &surface);
    else if (status == BATTEN_OK)
        status = batten_surface_skin((batten_curve_row){count, sections}, &options, run->job,
                                     NULL, &run->result->skin, &surface);
    release_lists(&given);
    if (status == BATTEN_OK && !bat_yes(run, "procedural"))
        status = bat_note_slivers(run, surface, "'within' finds knots that lie more evenly");
    return bat_put_surface(run, status, surface);
}

static batten_status run_skin(bat_run *run)
{
    bat_objects all;
    bat_tipped sections;
    batten_status status = bat_gather(run, "skin", BAT_CURVES | BAT_POINTS, &all);
    if (status != BATTEN_OK)
        return status;
    status = bat_take_tipped(&all, &sections);
    if (status == BATTEN_OK)
        status = skin(run, all.count, sections.curves);
    bat_tipped_release(&sections);
    bat_objects_release(&all);
    if (status != BATTEN_OK)
        return status;
    if (bat_yes(run, "procedural"))
        return BATTEN_OK;
    report_skin(run, &run->result->skin);
    run->result->shown.skin = &run->result->skin;
    bat_report_error(run, run->result->skin.error, run->result->skin.error);
    return BATTEN_OK;
}

const bat_feature bat_feature_skin = {
    .shown =
        {"skin", "The surface through sections",
         "u runs along the sections, v across them. Sections have knots of their own, and keeping\n"
         "all of them makes a heavy surface; with 'within' a few common knots are found such that\n"
         "no section moves farther than that. With 'spine' the sections are drawn in the xy-plane\n"
         "and placed along it.\n\n"
         "The first and the last section may be a point: a tip, or with 'poles: smooth' a pole with\n"
         "a tangent plane, that of the section next to it.\n\n"
         "A skin twists when points are joined that do not belong together: 'align' reverses\n"
         "sections that run against the one before and turns closed ones that start more than 45\n"
         "degrees off, and a note says which; 'turn' or 'starts' say where closed ones start, and\n"
         "'match' what lies between. Closed and open sections cannot be mixed; neighbours that\n"
         "cross or are out of order are named in a note.\n\n"
         "Between sections whose speeds or weights jump differently the surface has a crease where\n"
         "no section has a corner; it is found, and cured or kept as 'creases' says.",
         "features:\n"
         "  aft: {arc: 1 m, angle: 180 deg, axis: x, from: y}\n"
         "  mid: {arc: 1.4 m, angle: 180 deg, axis: x, from: y, at: [2 m, 0, 0]}\n"
         "  fore: {arc: 0.8 m, angle: 180 deg, axis: x, from: y, at: [4 m, 0, 0]}\n"
         "  hull: {skin: [aft, mid, fore], ends: natural}\n",
         "[LN12 section 12.8] [PT97 section 10.3]", "batten_surface_skin",
         BAT_PARAMETERS(parameters), false,
         .also =
             "loft, lofting, skinning, through sections, blend surface of sections, multi-section surface, frames, hull surface, wing",
         .formula =
             "    S(u, v) = Σ Σ d_ij N_i(u) N_j(v),  S(u, v_q) = C_q(u) for every section C_q",
         .promise =
             "The sections are isoparametric lines; with within no section moves farther."},
    .run = run_skin,
    .displacing = "spine"};
