/* Files of all kinds of entities in all formats: what a number loses is said. */
#include "exchange/replace.h"

static const struct {
    batten_format format;
    const char *file;
} seeds[] = {{BATTEN_FORMAT_IGES, "iges/arcs.igs"},
             {BATTEN_FORMAT_IGES, "iges/composite.igs"},
             {BATTEN_FORMAT_IGES, "iges/conics.igs"},
             {BATTEN_FORMAT_IGES, "iges/copious.igs"},
             {BATTEN_FORMAT_IGES, "iges/splines.igs"},
             {BATTEN_FORMAT_IGES, "iges/ruled.igs"},
             {BATTEN_FORMAT_IGES, "iges/turned.igs"},
             {BATTEN_FORMAT_IGES, "iges/offsets.igs"},
             {BATTEN_FORMAT_IGES, "iges/instances.igs"},
             {BATTEN_FORMAT_IGES, "iges/trimmed.igs"},
             {BATTEN_FORMAT_STEP, "step/assembly"},
             {BATTEN_FORMAT_STEP, "step/curve-rational_curve"},
             {BATTEN_FORMAT_STEP, "step/curve-spline_curve"},
             {BATTEN_FORMAT_STEP, "step/curve-trimmed_circle"},
             {BATTEN_FORMAT_STEP, "step/surface-rational"},
             {BATTEN_FORMAT_STEP, "step/surface-spline"},
             {BATTEN_FORMAT_STEP, "step/surface-torus"},
             {BATTEN_FORMAT_STEP, "step/surface-revolution"},
             {BATTEN_FORMAT_STEP, "step/tessellated"},
             {BATTEN_FORMAT_STEP, "step/mapped"},
             {BATTEN_FORMAT_STEP, "step/faces-with-parameters"},
             {BATTEN_FORMAT_DXF, "dxf/simple.dxf"},
             {BATTEN_FORMAT_DXF, "dxf/spline.dxf"},
             {BATTEN_FORMAT_DXF, "dxf/poly.dxf"},
             {BATTEN_FORMAT_DXF, "dxf/old-polylines.dxf"},
             {BATTEN_FORMAT_DXF, "dxf/blocks.dxf"},
             {BATTEN_FORMAT_SVG, "svg/shapes.svg"},
             {BATTEN_FORMAT_SVG, "svg/paths.svg"},
             {BATTEN_FORMAT_SVG, "svg/transforms.svg"},
             {BATTEN_FORMAT_SVG, "svg/lengths.svg"},
             {BATTEN_FORMAT_G2, "g2/curves.g2"},
             {BATTEN_FORMAT_G2, "g2/surfaces.g2"},
             {BATTEN_FORMAT_G2, "g2/elementary.g2"},
             {BATTEN_FORMAT_G2, "g2/trimmed.g2"},
             {BATTEN_FORMAT_OBJ, "obj/mesh.obj"},
             {BATTEN_FORMAT_OBJ, "obj/coloured.obj"},
             {BATTEN_FORMAT_OBJ, "obj/curves.obj"},
             {BATTEN_FORMAT_OBJ, "obj/surfaces.obj"},
             {BATTEN_FORMAT_STL, "stl/text.stl"},
             {BATTEN_FORMAT_PLY, "ply/ascii.ply"},
             {BATTEN_FORMAT_PCD, "pcd/ascii.pcd"},
             {BATTEN_FORMAT_OFF, "off/coloured.off"},
             {BATTEN_FORMAT_OFF, "off/normals.off"},
             {BATTEN_FORMAT_FTM, "ftm/net.ftm"},
             {BATTEN_FORMAT_OFFSET_TABLE, "offsets/long.csv"},
             {BATTEN_FORMAT_OFFSET_TABLE, "offsets/matrix.csv"},
             {BATTEN_FORMAT_OFFSET_TABLE, "offsets/loft.csv"},
             {BATTEN_FORMAT_AEROFOIL, "aerofoil/selig.dat"},
             {BATTEN_FORMAT_AEROFOIL, "aerofoil/lednicer.dat"},
             {BATTEN_FORMAT_POINTS, "points/plain.xyz"}};

/* Is the last bracket before a place that of "rgb("? */
static bool is_in_colour(const char *line, const char *place)
{
    while (place > line && place[-1] != '(' && place[-1] != ')')
        place--;
    return place >= line + 4 && memcmp(place - 4, "rgb(", 4) == 0;
}

/* Where a name, a layer, a colour or the like stands, or a place in the directory of IGES, of
 * which records.c has tests. */
static bool is_no_value(batten_format format, const char *text, size_t at)
{
    const char *line = text + at;
    while (line > text && line[-1] != '\n')
        line--;
    switch (format) {
    case BATTEN_FORMAT_IGES:
        return line[72] != 'P';
    case BATTEN_FORMAT_STEP:
        return at > 0 && strchr("#_'", text[at - 1]) != NULL;
    case BATTEN_FORMAT_DXF: /* codes, and what stands after 2, 8, 62, 420 */
        if (line - text < 4)
            return true;
        return line[-2] == '8' ||
               (line[-2] == '2' && (line[-3] == '\n' || line[-3] == ' ' || line[-3] == '6')) ||
               memcmp(line - 4, "420", 3) == 0;
    case BATTEN_FORMAT_OFFSET_TABLE:
    case BATTEN_FORMAT_AEROFOIL:
        return line == text;
    case BATTEN_FORMAT_SVG:
        return is_in_colour(line, text + at);
    default:
        return false;
    }
}

enum { ROOM = 20000 };

/* What was said, one after another. */
static void gather(const batten_notes *notes, char *all)
{
    all[0] = '\0';
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (!batten_notes_at(notes, i)->is_remark)
            strncat(all, batten_notes_at(notes, i)->text, ROOM - 1 - strlen(all));
}

typedef struct {
    batten_status status;
    char *said; /* [ROOM] */
    char *bytes;
    size_t size;
} outcome;

static outcome read_and_write(const char *text, batten_format format, char *room)
{
    outcome o = {.said = room};
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    o.status = read_text(text, format, notes, &model);
    CHECK((o.status == BATTEN_OK || o.status == BATTEN_PARTLY_READ) == (model != NULL));
    gather(notes, o.said);
    if (o.status == BATTEN_OK) /* of what is left there may be nothing that can be written */
        o.bytes = as_bytes(model, format, &o.size);
    else if (model)
        (void)to_bytes(model, format, &o.bytes, &o.size);
    batten_notes_free(notes);
    batten_model_unref(model);
    return o;
}

/* Is something else read, and the same said of it? */
static bool is_quiet(const outcome *plain, const outcome *bent)
{
    return bent->status == plain->status && strcmp(bent->said, plain->said) == 0 &&
           bent->bytes &&
           (bent->size != plain->size || memcmp(bent->bytes, plain->bytes, bent->size) != 0);
}

/* Where a number of any entity is replaced, the reader says so, or reads the same as before. */
static void check_never_quiet(const char *const *numbers, int count)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    int lost = 0;
    char *said = test_array(ROOM, 1), *said_plain = test_array(ROOM, 1);
    for (int s = 0; s < COUNT(seeds); s++) {
        const batten_format format = seeds[s].format;
        char path[300];
        size_t size = 0, length = 0;
        snprintf(path, sizeof path, "%sfuzz/corpus/%s", test_source(""), seeds[s].file);
        const char *text = load_bytes(path, &size);
        char *room = test_array(size + 100, 1);
        const outcome plain = read_and_write(text, format, said_plain);
        CHECK(plain.bytes != NULL);
        for (size_t at = 0; next_number(text, &at, &length); at += length)
            for (int i = 0; !is_no_value(format, text, at) && i < count; i++) {
                with_number(room, text, at, length, numbers[i]);
                if (format == BATTEN_FORMAT_IGES &&
                    (strlen(room) != size || at % 81 + strlen(numbers[i]) > 64))
                    continue; /* there is no room for it in the record */
                const outcome bent = read_and_write(room, format, said);
                const bool is_lost = is_quiet(&plain, &bent);
                if (is_lost)
                    printf("%s: %s for %.*s at byte %zu\n", seeds[s].file, numbers[i],
                           (int)length, text + at, at);
                lost += is_lost;
                batten_release(bent.bytes);
            }
        batten_release(plain.bytes);
    }
    CHECK_INT(lost, 0);
}

TEST(N1_a_number_that_is_none_is_never_lost_quietly)
{
    static const char *const numbers[] = {"nan", "-inf", "1e400"};
    check_never_quiet(numbers, COUNT(numbers));
}

TEST(N3_a_number_too_small_for_a_double_is_told_by_each_reader)
{
    static const char *const numbers[] = {"1e-400"};
    check_never_quiet(numbers, COUNT(numbers));
}

/* Where the next reference of STEP stands in the parameters of an instance, and its length. */
static bool next_reference(const char *text, size_t *at, size_t *length)
{
    for (size_t i = *at; text[i]; i++)
        if (text[i] == '#' && i > 0 && text[i - 1] != '\n') {
            *at = i;
            *length = 1 + strspn(text + i + 1, "0123456789");
            return true;
        }
    return false;
}

TEST(P1_a_reference_to_nothing_is_never_lost_quietly)
{
    /* $ may stand for directions that follow from the others. */
    static const char *const instead[] = {"#99999", "''"};
    char *said = test_array(ROOM, 1), *said_plain = test_array(ROOM, 1);
    int lost = 0;
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    for (int s = 0; s < COUNT(seeds); s++) {
        char path[300];
        size_t size = 0, length = 0;
        if (seeds[s].format != BATTEN_FORMAT_STEP)
            continue;
        snprintf(path, sizeof path, "%sfuzz/corpus/%s", test_source(""), seeds[s].file);
        const char *text = load_bytes(path, &size);
        char *room = test_array(size + 100, 1);
        const outcome plain = read_and_write(text, BATTEN_FORMAT_STEP, said_plain);
        for (size_t at = 0; next_reference(text, &at, &length); at += length)
            for (int i = 0; i < COUNT(instead); i++) {
                sprintf(room, "%.*s%s%s", (int)at, text, instead[i], text + at + length);
                const outcome bent = read_and_write(room, BATTEN_FORMAT_STEP, said);
                if (is_quiet(&plain, &bent)) {
                    printf("%s: %s for %.*s at byte %zu: %.60s\n", seeds[s].file, instead[i],
                           (int)length, text + at, at, text + (at > 40 ? at - 40 : 0));
                    lost++;
                }
                batten_release(bent.bytes);
            }
        batten_release(plain.bytes);
    }
    CHECK_INT(lost, 0);
}
