/* Finds the units and the accuracy of the context of a representation. */
#include "exchange/step/read/units.h"
#include "exchange/step/read/topology.h"

#include <batten/text.h>
#include <string.h>

/* A unit that is so many of another, which is so many of a third ... */
enum { CHAIN = 16 };

/* How many points tell how large the shape is, and how many times as far as the vertices other
 * points may reach to count. */
enum { SAMPLES = 1000, FAR = 1000 };

typedef enum { UNKNOWN, LENGTH, ANGLE, OTHER } quantity;

void bat_step_units_begin(bat_step_units *units)
{
    *units = (bat_step_units){.extent = -1};
}

/* ---- units ---- */

/* The factor of an SI prefix at argument k; 0 for an unknown one. */
static double prefix_at(const bat_step_file *file, const bat_step_record *record, int k)
{
    static const struct {
        const char *word;
        double factor;
    } prefixes[] = {/* the powers of ten of the SI, from exa to atto */
                    {"EXA", 1e18},  {"PETA", 1e15},  {"TERA", 1e12},   {"GIGA", 1e9},
                    {"MEGA", 1e6},  {"KILO", 1e3},   {"HECTO", 1e2},   {"DECA", 1e1},
                    {"DECI", 1e-1}, {"CENTI", 1e-2}, {"MILLI", 1e-3},  {"MICRO", 1e-6},
                    {"NANO", 1e-9}, {"PICO", 1e-12}, {"FEMTO", 1e-15}, {"ATTO", 1e-18}};
    if (bat_step_is_nothing(file, record, k))
        return 1;
    for (size_t i = 0; i < sizeof prefixes / sizeof prefixes[0]; i++)
        if (bat_step_is(file, record, k, prefixes[i].word))
            return prefixes[i].factor;
    return 0;
}

/* Units that are known by name, when what they are of is not said. */
static quantity named(const char *name, double *factor)
{
    char word[32] = "";
    for (size_t i = 0; i + 1 < sizeof word && name[i]; i++)
        word[i] = name[i] >= 'A' && name[i] <= 'Z' ? (char)(name[i] - 'A' + 'a') : name[i];
    const double metres = strcmp(word, "inch") == 0 ? 0.0254 : batten_unit_metres(word);
    if (metres > 0) {
        *factor = metres;
        return LENGTH;
    }
    if (strcmp(word, "degree") == 0 || strcmp(word, "degrees") == 0) {
        *factor = BAT_PI / 180;
        return ANGLE;
    }
    return UNKNOWN;
}

/* A CONVERSION_BASED_UNIT is `*factor` of the unit it hands back. */
static const bat_step_instance *base_of(const bat_step_file *file,
                                        const bat_step_record *conversion, double *factor)
{
    /* In the simple form the dimensions come first. */
    const int at = bat_step_argument_count(file, conversion) > 2 ? 2 : 1;
    const bat_step_instance *measure = NULL, *unit = NULL;
    if (bat_step_get_reference(file, conversion, at, &measure) != BATTEN_OK)
        return NULL;
    const bat_step_record *record = bat_step_as(file, measure, "MEASURE_WITH_UNIT");
    if (!record)
        record = bat_step_first(file, measure);
    double value = 0;
    if (bat_step_get_real(file, record, 0, &value) != BATTEN_OK ||
        bat_step_get_reference(file, record, 1, &unit) != BATTEN_OK)
        return NULL;
    *factor = value;
    return unit;
}

/* A factor that can be none does not go by: the name counts then, if it is one. */
static quantity of_name(const bat_step_file *file, const bat_step_instance *unit,
                        const char *name, double value, double *factor, bool *noted)
{
    const quantity what = named(name, factor);
    char shown[BAT_SHOWN_SIZE];
    if (*noted)
        return what;
    *noted = true;
    if (what == UNKNOWN)
        bat_step_warn(file, unit, "the unit '%s' has the factor %g; it is ignored",
                      bat_shown(name, strlen(name), shown), value);
    else
        bat_step_warn(file, unit, "the unit '%s' has the factor %g; by its name %g %s is taken",
                      bat_shown(name, strlen(name), shown), value, *factor,
                      what == LENGTH ? "m" : "radian");
    return what;
}

/* What the unit measures, and how many metres or radians it is; *noted: what is wrong with it
 * is said already. */
static quantity unit_of(const bat_step_file *file, const bat_step_instance *unit,
                        double *factor, bool *noted)
{
    char name[64] = "";
    double product = 1;
    for (int k = 0; k < CHAIN && unit; k++) {
        const bat_step_record *si = bat_step_as(file, unit, "SI_UNIT");
        const bat_step_record *conversion = bat_step_as(file, unit, "CONVERSION_BASED_UNIT");
        if (si) {
            const int at = bat_step_argument_count(file, si) > 2 ? 1 : 0;
            *factor = product * prefix_at(file, si, at);
            return !(*factor > 0)                            ? UNKNOWN
                   : bat_step_is(file, si, at + 1, "METRE")  ? LENGTH
                   : bat_step_is(file, si, at + 1, "RADIAN") ? ANGLE
                                                             : OTHER;
        }
        if (!conversion)
            break;
        double of = 1;
        const int at = bat_step_argument_count(file, conversion) > 2 ? 1 : 0;
        if (k == 0 && bat_step_get_string(file, conversion, at, sizeof name, name) != BATTEN_OK)
            name[0] = '\0';
        const bat_step_instance *base = base_of(file, conversion, &of);
        if (!(of > 0 && isfinite(of)))
            return of_name(file, unit, name, of, factor, noted);
        unit = base;
        product *= of;
    }
    return named(name, factor);
}

/* Conversions by a product of decimals: the unit they mean. */
static double round_to_unit(double metres)
{
    const char *name = batten_unit_name(metres);
    return name ? batten_unit_metres(name) : metres;
}

/* ---- accuracy ---- */

/* About how far instances of the keyword reach, from some of them: points, or the points that
 * vertices stand at. */
static double extent_of(const bat_step_file *file, const char *keyword, bool are_vertices)
{
    const bat_step_instance *instances = file->instances.items;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    const size_t count = file->instances.count, step = count / SAMPLES + 1;
    for (size_t i = 0; i < count; i += step) {
        const bat_step_scale plain = {1, 1, 1};
        const bat_step_record *record = NULL;
        double point[3];
        size_t k = i;
        for (; k < count && k < i + step && !record; k++)
            record = bat_step_as(file, &instances[k], keyword);
        const bat_step_instance *at = record ? &instances[k - 1] : NULL;
        if (!at ||
            (are_vertices && bat_step_get_reference(file, record, 1, &at) != BATTEN_OK) ||
            bat_step_read_point(file, at, &plain, point) != BATTEN_OK)
            continue;
        for (int d = 0; d < 3; d++) {
            low[d] = bat_min(low[d], point[d]);
            high[d] = bat_max(high[d], point[d]);
        }
    }
    double extent = 0;
    for (int d = 0; d < 3; d++)
        extent = bat_max(extent, high[d] - low[d]);
    return isfinite(extent) ? extent : 0;
}

/* A point far off all vertices, such as the origin of a plane, does not make the shape large.
 */
static double measure_extent(const bat_step_file *file)
{
    const double points = extent_of(file, "CARTESIAN_POINT", false);
    const double vertices = extent_of(file, "VERTEX_POINT", true);
    return vertices > 0 ? bat_min(points, FAR * vertices) : points;
}

/* The accuracy of lengths that the context states, in a unit; 0 when it does not. */
static double stated_accuracy(const bat_step_file *file, const bat_step_instance *context,
                              double unit_metres)
{
    const bat_step_record *record =
        context ? bat_step_as(file, context, "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT") : NULL;
    const int list =
        record && bat_step_argument_count(file, record) > 1 ? 2 : 0; /* the simple form */
    int count = 0;
    size_t at = 0;
    bool noted = true; /* of the units of the context it was */
    if (!record || bat_step_get_list(file, record, list, &count, &at) != BATTEN_OK)
        return 0;
    for (int k = 0; k < count; k++) {
        const bat_step_instance *measure = NULL, *unit = NULL;
        double value = 0, factor = 0;
        if (bat_step_item_reference(file, record, &at, &measure) != BATTEN_OK)
            return 0;
        const bat_step_record *of = bat_step_as(file, measure, "UNCERTAINTY_MEASURE_WITH_UNIT"),
                              *above = bat_step_as(file, measure, "MEASURE_WITH_UNIT");
        if (of && above) /* the complex form: value and unit stand there */
            of = above;
        if (of && bat_step_get_real(file, of, 0, &value) == BATTEN_OK && value > 0 &&
            bat_step_get_reference(file, of, 1, &unit) == BATTEN_OK &&
            unit_of(file, unit, &factor, &noted) == LENGTH)
            return value * (round_to_unit(factor) / unit_metres);
    }
    return 0;
}

/* What the file states, when it makes sense for its size: finer is raised to 1e-12 of it,
 * coarser or nothing replaced by a millionth. */
static double accuracy(const bat_step_file *file, bat_step_units *units,
                       const bat_step_instance *context, double metres)
{
    const double stated = stated_accuracy(file, context, units->unit_metres);
    if (units->extent < 0)
        units->extent = measure_extent(file);
    const double size = units->extent * metres / units->unit_metres;
    /* Where the model has no size: a nanometre. */
    const double usual = bat_judged_accuracy(stated, size, 1e-2, 1e-9 / units->unit_metres);
    if (usual == stated)
        return stated;
    if (!units->noted_accuracy && stated > 0)
        batten_notes_remark(file->input->notes, file->input->file, 0, "",
                            "the file states an accuracy of %g at a size of %g; %g is used",
                            stated, size, usual);
    else if (!units->noted_accuracy)
        batten_notes_remark(file->input->notes, file->input->file, 0, "",
                            "the file states no accuracy; %g is used", usual);
    units->noted_accuracy = true;
    return usual;
}

/* ---- contexts ---- */

/* Metres and radians of the units of a context; 0 where it has none. */
static void read_units(const bat_step_file *file, bat_step_units *units,
                       const bat_step_instance *context, double *metres, double *radians)
{
    const bat_step_record *record =
        context ? bat_step_as(file, context, "GLOBAL_UNIT_ASSIGNED_CONTEXT") : NULL;
    const int list = record && bat_step_argument_count(file, record) > 1 ? 2 : 0;
    int count = 0;
    size_t at = 0;
    *metres = *radians = 0;
    if (!record || bat_step_get_list(file, record, list, &count, &at) != BATTEN_OK)
        return;
    for (int k = 0; k < count; k++) {
        const bat_step_instance *unit = NULL;
        double factor = 0;
        if (bat_step_item_reference(file, record, &at, &unit) != BATTEN_OK)
            continue;
        const quantity of = unit_of(file, unit, &factor, &units->noted_factor);
        if (of == LENGTH && *metres == 0)
            *metres = round_to_unit(factor);
        if (of == ANGLE && *radians == 0)
            *radians = factor;
    }
}

void bat_step_units_of(const bat_step_file *file, bat_step_units *units,
                       const bat_step_instance *context, bat_step_scale *scale)
{
    batten_notes *notes = file->input->notes;
    double metres = 0, radians = 0;
    const int line = context ? bat_step_line(file, context->at) : 0;
    if (context && context == units->last) {
        *scale = units->scale;
        return;
    }
    read_units(file, units, context, &metres, &radians);
    if (metres == 0) {
        metres = 0.001;
        if (!units->noted_none)
            batten_notes_add(notes, file->input->file, line, "",
                             "the file gives no unit of length; millimetres are assumed");
        units->noted_none = true;
    }
    if (radians == 0) {
        radians = 1;
        if (!units->noted_angle)
            batten_notes_remark(notes, file->input->file, line, "",
                                "the file gives no unit of angle; radians are assumed");
        units->noted_angle = true;
    }
    if (units->unit_metres == 0)
        units->unit_metres = metres;
    if (metres != units->unit_metres && !units->noted_other) {
        batten_notes_remark(notes, file->input->file, line, "",
                            "parts in a unit of %g m are scaled into that of the model, %g m",
                            metres, units->unit_metres);
        units->noted_other = true;
    }
    *scale = (bat_step_scale){.length = metres / units->unit_metres, .angle = radians};
    scale->tolerance = accuracy(file, units, context, metres);
    units->last = context;
    units->scale = *scale;
}
