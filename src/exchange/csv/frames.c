/* Reads tables of frames, numbers alone: PIAS' rows of y and z, PDSTRIP's lists of y and then of z. */
#include "exchange/csv/csv.h"
#include "exchange/reading/words.h"

/*
 *     2              frames                2 T 0.96         sections, a mark, the draught
 *     0.0            x                     -7.5  3  0       x, points, gaps
 *     3              points                0.0 0.15 0.25    y
 *     0.0 0.0        y z, perhaps a mark   0.91 0.92 0.95   z
 *     ...                                  ...
 */
typedef struct {
    bat_words words;
    bat_gathering *gathering;
    int frame;
    double x;
    int marks; /* of points; what they mean is not kept */
} frames;

/* The counts distinguish frames from other rows of numbers: they must add up exactly. */
enum { MOST_FRAMES = 10000, MOST_POINTS = 10000 };

static batten_status add_point(frames *f, double y, double z)
{
    const bat_gathered point = {.station = f->x,
                                .x = f->x,
                                .y = y,
                                .z = z,
                                .row = f->words.line,
                                .source = f->frame + 1};
    return bat_gather_point(f->gathering, &point);
}

/* The next word stands in the line of the one before. */
static bool has_more_in_line(const bat_words *words)
{
    bat_words next = *words;
    return bat_words_next(&next) && next.line == words->line;
}

static batten_status read_pias_frame(frames *f)
{
    int count = 0;
    batten_status status = bat_words_real(&f->words, "x of a frame", &f->x);
    if (status == BATTEN_OK)
        status = bat_words_integer(&f->words, "the number of points of a frame", 1, MOST_POINTS,
                                   &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        double y = 0, z = 0, mark = 0;
        status = bat_words_real(&f->words, "y of a point", &y);
        if (status == BATTEN_OK)
            status = bat_words_real(&f->words, "z of a point", &z);
        if (status == BATTEN_OK && has_more_in_line(&f->words))
            status = bat_words_real(&f->words, "the mark of a point", &mark);
        f->marks += mark != 0;
        if (status == BATTEN_OK)
            status = add_point(f, y, z);
    }
    return status;
}

static batten_status read_pdstrip_section(frames *f)
{
    int count = 0, gaps = 0;
    double *y = NULL, *z = NULL;
    bat_input *input = f->words.input;
    batten_status status = bat_words_real(&f->words, "x of a section", &f->x);
    if (status == BATTEN_OK)
        status = bat_words_integer(&f->words, "the number of points of a section", 1,
                                   MOST_POINTS, &count);
    if (status == BATTEN_OK)
        status =
            bat_words_integer(&f->words, "the number of gaps of a section", 0, count, &gaps);
    for (int i = 0; status == BATTEN_OK && i < gaps; i++) {
        int gap = 0;
        status = bat_words_integer(&f->words, "a gap of a section", 1, count, &gap);
    }
    if (status == BATTEN_OK)
        status = bat_words_reals(&f->words, "y of a section", (size_t)count, &y);
    if (status == BATTEN_OK)
        status = bat_words_reals(&f->words, "z of a section", (size_t)count, &z);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = add_point(f, y[i], z[i]);
    if (status == BATTEN_OK && gaps)
        batten_notes_add(input->notes, input->file, f->words.line, "",
                         "section %d has %d gap%s; its points are taken as one line",
                         f->frame + 1, gaps, gaps == 1 ? "" : "s");
    bat_release(y);
    bat_release(z);
    return status;
}

/* "19 T 0.96": the second word is a mark of symmetry, T or F. */
static bool is_pdstrip(bat_words words)
{
    return bat_words_next(&words) && bat_words_next(&words) && words.word.length == 1 &&
           (words.word.bytes[0] == 'T' || words.word.bytes[0] == 'F');
}

static batten_status read_pdstrip_head(frames *f, int *count)
{
    double draught = 0;
    batten_status status =
        bat_words_integer(&f->words, "the number of sections", 1, MOST_FRAMES, count);
    bat_words_next(&f->words);
    return status == BATTEN_OK ? bat_words_real(&f->words, "the draught", &draught) : status;
}

static batten_status read_frames(bat_input *input, bat_gathering *gathering)
{
    frames f = {.gathering = gathering};
    int count = 0;
    bat_words_begin(&f.words, input);
    const bool lists = is_pdstrip(f.words);
    batten_status status =
        lists ? read_pdstrip_head(&f, &count)
              : bat_words_integer(&f.words, "the number of frames", 1, MOST_FRAMES, &count);
    gathering->as_listed = true;
    for (; status == BATTEN_OK && f.frame < count; f.frame++)
        status = lists ? read_pdstrip_section(&f) : read_pias_frame(&f);
    if (status == BATTEN_OK && f.marks)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "%d point%s marked; tables of offsets have no marks", f.marks,
                            f.marks == 1 ? " is" : "s are");
    bat_words rest = f.words;
    if (status == BATTEN_OK && bat_words_next(&rest))
        status =
            bat_input_fail(input, BATTEN_BAD_FORMAT, rest.line,
                           "something follows the %d frames that the file announces", count);
    return status;
}

batten_status bat_are_frames(const bat_input *input, bool *are_frames)
{
    bat_input copy = *input;
    bat_gathering gathering;
    copy.notes = NULL;
    bat_gather_begin(&gathering, &copy);
    const batten_status status = read_frames(&copy, &gathering);
    bat_gather_end(&gathering);
    *are_frames = status == BATTEN_OK;
    return bat_input_ends(status) ? status : BATTEN_OK;
}

batten_status bat_offsets_frames(bat_input *input, bat_gathering *gathering)
{
    return read_frames(input, gathering);
}
