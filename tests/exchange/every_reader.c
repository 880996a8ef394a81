/* What holds for each reader alike: one small file of every format, bent in the ways of the
 * catalogue. */
#define _XOPEN_SOURCE 700
#include <limits.h>
#include <locale.h>
#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#include "exchange/every_format.h"
#include "exchange/replace.h"

static void check_same(const batten_model *a, const batten_model *b, batten_format format)
{
    size_t n = 0, m = 0;
    char *p = as_bytes(a, format, &n), *q = as_bytes(b, format, &m);
    CHECK(n == m && memcmp(p, q, n) == 0);
    batten_release(p);
    batten_release(q);
}

/* Memory failing in turn is the affair of each reader's own tests. */
static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
}

TEST(F1_nothing_in_a_file_is_refused_by_each_reader)
{
    static const char *const texts[] = {"",   "x",    " \n\t\r\n \n", "\xff",
                                        "\n", "\x1a", "\xef\xbb\xbf"};
    for (int f = 0; f < COUNT(every_format); f++)
        for (int i = 0; i < COUNT(texts); i++) {
            batten_model *model = NULL;
            const batten_status status =
                read_text(texts[i], every_format[f].format, NULL, &model);
            CHECK(status != BATTEN_OK && status != BATTEN_PARTLY_READ && model == NULL);
            CHECK(strlen(batten_message()) > 3);
        }
}

TEST(F2_no_cut_harms_any_reader)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++)
        for (size_t length = 0; length < strlen(every_format[f].text); length++) {
            batten_model *model = NULL;
            batten_notes *notes = NULL;
            char *exact = malloc(length ? length : 1); /* reading past the end shows */
            CHECK(exact != NULL);
            memcpy(exact, every_format[f].text, length);
            CHECK_OK(batten_notes_create(10, &notes));
            const batten_status status =
                read_bytes(exact, length, every_format[f].format, notes, &model);
            free(exact);
            CHECK((status == BATTEN_OK || status == BATTEN_PARTLY_READ) == (model != NULL));
            /* All that is left of a last record or line may be enough. */
            if (every_format[f].has_end && length + 10 < strlen(every_format[f].text))
                CHECK(status != BATTEN_OK || count_warnings(notes) > 0);
            batten_notes_free(notes);
            batten_model_unref(model);
        }
}

/* ---- ends of lines ---- */

static char *with_ends(const char *text, const char *const ends[2])
{
    char *made = test_array(2 * strlen(text) + 1, 1), *to = made;
    int line = 0;
    for (; *text; text++) {
        const char *put = *text == '\n' ? ends[line++ % 2] : (const char[]){*text, 0};
        memcpy(to, put, strlen(put));
        to += strlen(put);
    }
    return made;
}

static void check_as(int f, const char *text, size_t size)
{
    batten_model *plain = NULL, *model = NULL;
    CHECK_OK(read_text(every_format[f].text, every_format[f].format, NULL, &plain));
    CHECK_OK(read_bytes(text, size, every_format[f].format, NULL, &model));
    check_same(plain, model, every_format[f].format);
    batten_model_unref(plain);
    batten_model_unref(model);
}

TEST(F3_ends_of_lines_mean_the_same_to_each_reader)
{
    static const char *const ends[][2] = {{"\r\n", "\r\n"}, {"\r", "\r"}, {"\r\n", "\n"}};
    only_once();
    for (int f = 0; f < COUNT(every_format); f++)
        for (int e = 0; e < COUNT(ends); e++) {
            const char *text = with_ends(every_format[f].text, ends[e]);
            check_as(f, text, strlen(text));
        }
}

TEST(F3_blank_lines_after_the_end_and_a_missing_newline_mean_nothing)
{
    static const char *const tails[] = {"\n\n \n", "\x1a", "\r\n\x1a"};
    only_once();
    for (int f = 0; f < COUNT(every_format); f++) {
        const size_t length = strlen(every_format[f].text);
        check_as(f, every_format[f].text, length - 1);
        for (int i = 0; i < COUNT(tails); i++) {
            char *text = test_array(length + 8, 1);
            sprintf(text, "%s%s", every_format[f].text, tails[i]);
            check_as(f, text, strlen(text));
        }
    }
}

/* ---- encodings ---- */

TEST(F4_a_byte_order_mark_means_nothing_to_each_reader)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++) {
        const char *text = every_format[f].text;
        char *marked = test_array(strlen(text) + 4, 1);
        sprintf(marked, "\xef\xbb\xbf%s", text);
        check_as(f, marked, strlen(marked));
    }
}

TEST(F4_UTF_16_and_zero_bytes_are_refused_by_each_reader)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++)
        for (int way = 0; way < 3; way++) {
            const char *text = every_format[f].text;
            const size_t length = strlen(text);
            char *wide = test_array(2 * length + 4, 1);
            batten_model *model = NULL;
            size_t size = 2 * length + 2;
            memcpy(wide, way == 1 ? "\xfe\xff" : "\xff\xfe", 2);
            for (size_t i = 0; i < length; i++)
                wide[2 + 2 * i + (way == 1)] = text[i];
            if (way == 2) { /* one zero byte in the middle of plain text */
                memcpy(wide, text, size = length);
                wide[length / 2] = '\0';
            }
            const batten_status status =
                read_bytes(wide, size, every_format[f].format, NULL, &model);
            CHECK(status != BATTEN_OK && status != BATTEN_PARTLY_READ && model == NULL);
            /* Headers of clouds and meshes say themselves what no line of them is. */
            CHECK(strncmp(batten_message(), "t:", 2) == 0);
            CHECK(strstr(batten_message(), way < 2 ? "UTF-16" : "is zero; this is not text") ||
                  (way == 2 && strstr(batten_message(), "unknown header line")));
        }
}

#define ODD_NAME "k\xfcl\xff"

TEST(F4_names_keep_their_bytes_in_each_reader)
{
    static const struct {
        batten_format format;
        const char *text;
    } cases[] = {
        {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n" ODD_NAME
                            "\n10\n1\n20\n2\n11\n3\n21\n4\n0\nENDSEC\n0\nEOF\n"},
        {BATTEN_FORMAT_SVG,
         "<svg><line id=\"" ODD_NAME "\" x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/></svg>"},
        {BATTEN_FORMAT_OBJ, "o " ODD_NAME "\nv 0 0 0\nv 1 0 0\nv 1 1.5 0\nf 1 2 3\n"},
        {BATTEN_FORMAT_STL,
         "solid " ODD_NAME "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
         "vertex 0 1.5 0\nendloop\nendfacet\nendsolid s\n"},
        {BATTEN_FORMAT_AEROFOIL, ODD_NAME "\n1.0 .01\n.5 .1\n0 0\n.4 -.05\n1 -.01\n"},
        {BATTEN_FORMAT_STEP,
         STEP_BEGIN "#1=CARTESIAN_POINT('',(1.,2.,3.));\n#2=CARTESIAN_POINT('',(1.5,2.,4.));\n"
                    "#4=POLYLINE('" ODD_NAME "',(#1,#2));\n" STEP_CONTEXT STEP_END},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(cases[i].text, cases[i].format, NULL, &model));
        const batten_object *object = batten_model_object(model, 0);
        CHECK_TEXT(cases[i].format == BATTEN_FORMAT_DXF ? object->layer : object->name,
                   ODD_NAME);
        batten_model_unref(model);
    }
}

TEST(F4_bytes_that_are_no_text_harm_no_reader)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++) {
        char *text = test_array(strlen(every_format[f].text) + 1, 1);
        for (size_t i = 0; i < strlen(every_format[f].text); i++) {
            batten_model *model = NULL;
            strcpy(text, every_format[f].text);
            text[i] = '\xe9';
            read_text(text, every_format[f].format, NULL, &model);
            batten_model_unref(model);
        }
    }
}

/* ---- locales, names, content ---- */

TEST(F5_each_reader_and_writer_ignores_the_locale)
{
    only_once();
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        SKIP("the locale de_DE.UTF-8 is not installed");
    setlocale(LC_ALL, "C");
    for (int f = 0; f < COUNT(every_format); f++)
        for (int to = BATTEN_FORMAT_OFFSET_TABLE; to <= BATTEN_FORMAT_OFF; to++) {
            batten_model *plain = NULL, *other = NULL;
            char *a = NULL, *b = NULL;
            size_t n = 0, m = 0;
            CHECK_OK(read_text(every_format[f].text, every_format[f].format, NULL, &plain));
            const batten_status one = write_bytes(plain, (batten_format)to, &a, &n);
            setlocale(LC_ALL, "de_DE.UTF-8");
            const batten_status reading =
                read_text(every_format[f].text, every_format[f].format, NULL, &other);
            const batten_status two =
                reading == BATTEN_OK ? write_bytes(other, (batten_format)to, &b, &m) : reading;
            setlocale(LC_ALL, "C");
            CHECK_INT(reading, BATTEN_OK);
            CHECK_INT(one, two);
            CHECK(n == m && (n == 0 || memcmp(a, b, n) == 0));
            batten_release(a);
            batten_release(b);
            batten_model_unref(plain);
            batten_model_unref(other);
        }
}

TEST(F7_each_format_is_known_by_its_content_and_refused_as_another)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++)
        for (int as = 0; as < COUNT(every_format); as++) {
            batten_model *model = NULL;
            const batten_status status =
                read_text(every_format[f].text, every_format[as].format, NULL, &model);
            const bool rows = !every_format[f].is_known && !every_format[as].is_known;
            if (f == as || !rows)
                CHECK((status == BATTEN_OK) == (f == as));
            if (status != BATTEN_OK && every_format[f].is_known)
                CHECK_MESSAGE("the content is that of ");
            batten_model_unref(model);
        }
    for (int f = 0; f < COUNT(every_format); f++) {
        const char *path = test_scratch("other.xyz");
        batten_model *model = NULL, *plain = NULL;
        if (!every_format[f].is_known)
            continue;
        CHECK_OK(batten_save_file(path, every_format[f].text, strlen(every_format[f].text)));
        CHECK_OK(batten_read_file(path, NULL, NULL, NULL, &model));
        CHECK_OK(read_text(every_format[f].text, every_format[f].format, NULL, &plain));
        check_same(plain, model, every_format[f].format);
        batten_model_unref(model);
        batten_model_unref(plain);
    }
}

static int warnings_of(const char *text, batten_format format, batten_status *status)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    *status = read_text(text, format, notes, &model);
    const int count = count_warnings(notes);
    batten_notes_free(notes);
    batten_model_unref(model);
    return count;
}

TEST(F7_what_follows_the_end_of_a_file_is_told_by_each_reader)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++)
        for (int other = 0; other < COUNT(every_format); other++) {
            char glued[4096];
            batten_status status;
            const batten_format format = every_format[f].format;
            /* Hydrostatics and the like follow the net of a ship. */
            if (f == other || format == BATTEN_FORMAT_FTM)
                continue;
            const int before = warnings_of(every_format[f].text, format, &status);
            CHECK(status == BATTEN_OK);
            CHECK((size_t)snprintf(glued, sizeof glued, "%s%s", every_format[f].text,
                                   every_format[other].text) < sizeof glued);
            const int after = warnings_of(glued, format, &status);
            const bool rows = !every_format[f].is_known && !every_format[other].is_known;
            CHECK(rows || status != BATTEN_OK || after > before);
        }
}

TEST(F8_each_reader_takes_odd_names_of_files)
{
    static const char *const names[] = {"a b", "a'b\"", "a\nb", "\xff\xfe", "-x", "%s%n"};
    static const char *const shown[] = {"a b", "a'b\"", "a\\x0ab", "\\xff\\xfe", "-x", "%s%n"};
    only_once();
    for (int f = 0; f < COUNT(every_format); f++)
        for (int i = 0; i < COUNT(names); i++) {
            const char *path = test_scratch(names[i]);
            batten_read_options options = batten_read_defaults();
            batten_model *model = NULL;
            options.format = every_format[f].format;
            CHECK_OK(
                batten_save_file(path, every_format[f].text, strlen(every_format[f].text)));
            CHECK_OK(batten_read_file(path, &options, NULL, NULL, &model));
            batten_model_unref(model);
            CHECK_OK(batten_save_file(path, "\x01", 1));
            CHECK(batten_read_file(path, &options, NULL, NULL, &model) != BATTEN_OK);
            CHECK(strstr(batten_message(), shown[i]) != NULL);
            CHECK(strpbrk(batten_message(), "\n\xff") == NULL);
        }
}

/* ---- a small stack ---- */

typedef struct {
    char *texts[COUNT(nested)];
    batten_status results[COUNT(nested)];
} deep_files;

static void *read_all_small(void *user)
{
    deep_files *all = user;
    for (int f = 0; f < COUNT(every_format); f++) {
        batten_model *model = NULL;
        read_text(every_format[f].text, every_format[f].format, NULL, &model);
        batten_model_unref(model);
    }
    for (int i = 0; i < COUNT(nested); i++) {
        batten_model *model = NULL;
        all->results[i] = read_text(all->texts[i], nested[i].format, NULL, &model);
        batten_model_unref(model);
    }
    return NULL;
}

TEST(S4_each_reader_works_in_a_small_stack_however_deep_its_file_is)
{
    enum { DEPTH = 100000, STACK = 256 * 1024 };
    deep_files all;
    pthread_attr_t attributes;
    pthread_t thread;
    only_once();
    for (int i = 0; i < COUNT(nested); i++) {
        const size_t length = strlen(nested[i].open);
        all.texts[i] = test_array(strlen(nested[i].before) + DEPTH * length + 1, 1);
        char *to = all.texts[i] + sprintf(all.texts[i], "%s", nested[i].before);
        for (int k = 0; k < DEPTH; k++, to += length)
            memcpy(to, nested[i].open, length);
    }
    CHECK(pthread_attr_init(&attributes) == 0);
    if (!SANITIZED)
        CHECK(pthread_attr_setstacksize(&attributes, STACK) == 0);
    CHECK(pthread_create(&thread, &attributes, read_all_small, &all) == 0);
    CHECK(pthread_join(thread, NULL) == 0);
    pthread_attr_destroy(&attributes);
    /* A line of OBJ may go on as long as it likes. */
    for (int i = 0; i < COUNT(nested); i++)
        CHECK(all.results[i] != BATTEN_OK || nested[i].format == BATTEN_FORMAT_OBJ);
}

/* Parts within parts: each definition has the next in it so many times. */
static char *chain_of_dxf(int deep, int times)
{
    char *text = test_array((size_t)deep * (60 + 40 * (size_t)times) + 400, 1);
    char *to = text + sprintf(text, "0\nSECTION\n2\nBLOCKS\n");
    for (int k = 0; k < deep; k++) {
        to += sprintf(to, "0\nBLOCK\n2\nb%d\n10\n0\n20\n0\n", k);
        for (int i = 0; i < times && k + 1 < deep; i++)
            to += sprintf(to, "0\nINSERT\n2\nb%d\n10\n1\n20\n%d\n", k + 1, i);
        to += sprintf(to, "%s0\nENDBLK\n", k + 1 < deep ? "" : "0\nPOINT\n10\n1\n20\n2\n");
    }
    sprintf(to, "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nb0\n10\n0\n20\n0\n0\n"
                "ENDSEC\n0\nEOF\n");
    return text;
}

static char *chain_of_step(int deep, int times)
{
    char *text = test_array((size_t)deep * (200 + 80 * (size_t)times) + 2000, 1);
    char *to = text + sprintf(text, "%s%s", STEP_BEGIN, STEP_CONTEXT);
    to += sprintf(to, "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,2.,4.));\n"
                      "#4=POLYLINE('',(#1,#2));\n#5=AXIS2_PLACEMENT_3D('',#1,$,$);\n"
                      "#6=AXIS2_PLACEMENT_3D('',#2,$,$);\n");
    for (int k = 0; k < deep; k++) {
        const int id = 1000 + 10 * k;
        to += sprintf(to, "#%d=SHAPE_REPRESENTATION('',(#5", id);
        for (int i = 0; i < times && k + 1 < deep; i++)
            to += sprintf(to, ",#%d", id + 2 + i);
        to += sprintf(to, "%s),#94);\n#%d=REPRESENTATION_MAP(#5,#%d);\n",
                      k + 1 < deep ? "" : ",#4", id + 1, id);
        for (int i = 0; i < times && k + 1 < deep; i++)
            to += sprintf(to, "#%d=MAPPED_ITEM('',#%d,#6);\n", id + 2 + i, id + 11);
    }
    strcpy(to, STEP_END);
    return text;
}

TEST(S4_parts_within_parts_have_a_limit_and_doubling_takes_no_longer)
{
    enum { SMALL = 20, DEEP = 100 };
    only_once();
    for (int k = 0; k < 2; k++) {
        const batten_format format = k ? BATTEN_FORMAT_STEP : BATTEN_FORMAT_DXF;
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(1000, &notes));
        const char *doubling = k ? chain_of_step(SMALL, 2) : chain_of_dxf(SMALL, 2);
        CHECK_OK(read_text(doubling, format, NULL, &model));
        CHECK(batten_model_depth(model) >= SMALL - 1);
        batten_model_unref(model);
        model = NULL;
        const char *chain = k ? chain_of_step(DEEP, 1) : chain_of_dxf(DEEP, 1);
        const batten_status status = read_text(chain, format, notes, &model);
        CHECK(status != BATTEN_OK);
        CHECK(strstr(batten_message(), " 32 ") != NULL || has_note(notes, " 32 "));
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* ---- time ---- */

/* Copy text with numbers in the place of @ and ^. */
static char *copy_with(char *to, const char *text, int number, int count)
{
    for (; *text; text++)
        if (*text == '@' || *text == '^')
            to += sprintf(to, "%d", *text == '@' ? number : count);
        else
            *to++ = *text;
    *to = '\0';
    return to;
}

typedef struct {
    batten_format format;
    const char *before, *again, *after; /* as in every_format */
} lengthy;

static char *make_long(const lengthy *l, int count)
{
    const size_t one = strlen(l->again) + 32;
    char *text = test_array(strlen(l->before) + (size_t)count * one + strlen(l->after) + 64, 1);
    char *to = copy_with(text, l->before, 0, count);
    for (int k = 0; k < count; k++)
        to = copy_with(to, l->again, k + 1000, count);
    copy_with(to, l->after, 0, count);
    return text;
}

static double seconds_to_read(const char *text, batten_format format, bool is_good)
{
    double best = 1e9;
    for (int attempt = 0; attempt < 3; attempt++) {
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(50, &notes));
        const clock_t start = clock();
        const batten_status status = read_text(text, format, notes, &model);
        best = fmin(best, (double)(clock() - start) / CLOCKS_PER_SEC);
        CHECK(!is_good || status == BATTEN_OK);
        CHECK(batten_notes_count(notes) <= 50);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
    return best;
}

/* Four times as much takes four times as long; were it quadratic, sixteen times. */
static void check_proportion(const char *one, const char *four, batten_format format,
                             bool is_good, const char *what)
{
    const double a = seconds_to_read(one, format, is_good);
    const double b = seconds_to_read(four, format, is_good);
    if (b > 10 * fmax(a, 1e-3))
        printf("%s, %s: %g s, then %g s\n", batten_format_name(format), what, a, b);
    CHECK(b <= 10 * fmax(a, 1e-3));
}

enum { FEW = 2000 };

TEST(S3_each_reader_takes_time_in_proportion_to_the_file)
{
    only_once();
    for (int f = 0; f < COUNT(every_format); f++) {
        const every *e = &every_format[f];
        const lengthy l = {e->format, e->before, e->again, e->after};
        if (e->again)
            check_proportion(make_long(&l, FEW), make_long(&l, 4 * FEW), e->format, true, "");
    }
}

/* Errors, comments and equal labels, many times over. */
static const lengthy oddities[] = {
    {BATTEN_FORMAT_STEP, STEP_BEGIN, "#@=CARTESIAN_POINT('',(1.,x));\n", STEP_END},
    {BATTEN_FORMAT_STEP, STEP_BEGIN, "#5=CARTESIAN_POINT('',(1.,2.));\n", STEP_END},
    {BATTEN_FORMAT_STEP, STEP_BEGIN, "#@=POLYLINE('same',(#@,#1));\n", STEP_END},
    {BATTEN_FORMAT_STEP, STEP_BEGIN, "#@=BANANA@(#@);\n", STEP_END},
    {BATTEN_FORMAT_STEP, STEP_BEGIN, "/* ' */\n", STEP_END},
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nENTITIES\n", "0\nLINE\n8\nk\n10\nx\n",
     "0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nENTITIES\n", "0\nINSERT\n2\nb@\n10\n1\n",
     "0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nENTITIES\n", "0\nBANANA@\n8\nk\n",
     "0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n",
     "0\nLAYER\n2\nk\n62\n3\n", "0\nENDTAB\n0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nBLOCKS\n", "0\nBLOCK\n2\nk\n0\nENDBLK\n",
     "0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_DXF, "999\nnone\n", "999\na comment\n",
     "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_SVG, "<svg>", "<path id=\"a\" d=\"x\"/>\n", "</svg>"},
    {BATTEN_FORMAT_SVG, "<svg>", "<g id=\"a\"><banana@/></g>\n", "</svg>"},
    {BATTEN_FORMAT_SVG, "<svg>", "<!-- < -->\n", "</svg>"},
    {BATTEN_FORMAT_SVG, "<svg>", "<path d=\"M0 0L1 1\n", "</svg>"},
    {BATTEN_FORMAT_G2, "", "100 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n0 0 x\n", ""},
    {BATTEN_FORMAT_G2, "100 1 0 0\n", "7 ", "\n"},
    {BATTEN_FORMAT_OBJ, "v 0 0 0\n", "g same\nv x\nf 1 9 -9\n", ""},
    {BATTEN_FORMAT_OBJ, "v 0 0 0\n", "cstype bezier\ndeg 9\ncurv 0 1 1 x\nend\n", ""},
    {BATTEN_FORMAT_OBJ, "v 0 0 0\n", "banana@ 1 2\n", ""},
    {BATTEN_FORMAT_OBJ, "v 0 0 0\n", "# comment \\\n", ""},
    {BATTEN_FORMAT_STL, "solid s\n", "facet normal 0 0 1\nouter vertex 1\n", "endsolid\n"},
    {BATTEN_FORMAT_STL, "", "solid same\nendsolid same\n", ""},
    {BATTEN_FORMAT_PLY,
     "ply\nformat ascii 1.0\nelement vertex ^\nproperty float x\nproperty float y\n"
     "property float z\nend_header\n",
     "1 x\n", ""},
    {BATTEN_FORMAT_PLY,
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
     "property float z\n",
     "property float same\n", "end_header\n0 0 0\n"},
    {BATTEN_FORMAT_PLY, "ply\nformat ascii 1.0\n", "element same 0\n", "end_header\n0 0 0\n"},
    {BATTEN_FORMAT_PLY, "ply\nformat ascii 1.0\n", "comment c\n",
     "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
     "0 0 0\n"},
    {BATTEN_FORMAT_PCD,
     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH ^\nHEIGHT 1\n"
     "POINTS ^\nDATA ascii\n",
     "1 x\n", ""},
    {BATTEN_FORMAT_PCD, "", "# comment\n", "VERSION 0.7\nFIELDS x y z\n"},
    {BATTEN_FORMAT_OFF, "OFF\n^ 0 0\n", "0 x\n", ""},
    {BATTEN_FORMAT_OFF, "OFF\n1 ^ 0\n0 0 0\n", "3 0 0 9\n", ""},
    {BATTEN_FORMAT_OFFSET_TABLE, "station,x,y,z\n", "same,0,1,2\n", ""},
    {BATTEN_FORMAT_OFFSET_TABLE, "station,x,y,z\n", "#c\n", "1,0,1,1\n1,0,2,2\n"},
    {BATTEN_FORMAT_POINTS, "", "1 2\n\n", ""},
    {BATTEN_FORMAT_AEROFOIL, "RAE\n", "1 0\n\n", ""},
};

TEST(S3_errors_comments_and_equal_labels_take_no_longer)
{
    only_once();
    for (int i = 0; i < COUNT(oddities); i++) {
        char what[20];
        snprintf(what, sizeof what, "case %d", i);
        check_proportion(make_long(&oddities[i], FEW), make_long(&oddities[i], 4 * FEW),
                         oddities[i].format, false, what);
    }
}

/* `count` lines of IGES with parameters that are none, or with records that are none. */
static char *iges_of_errors(int count, bool are_records)
{
    char *text = test_array((size_t)count * 260 + 1000, 1);
    char *to = text + sprintf(text, "%-72sS%7d\n%-72sG%7d\n", "hand-made", 1,
                              "1H,,1H;,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM;", 1);
    for (int k = 0; k < count; k++)
        to += sprintf(to, "%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d\n%8d%8d%8d%8d%8d%32dD%7d\n", 110,
                      k + 1, 0, 0, 0, 0, 0, 0, "00000000", 2 * k + 1, 110, 0, 0, 1, 0, 0,
                      2 * k + 2);
    for (int k = 0; k < count; k++)
        to += sprintf(to, "%-64s%8d%c%7d\n", "110,1.,x;", 2 * k + 1, are_records ? 'x' : 'P',
                      k + 1);
    sprintf(to, "S%7dG%7dD%7dP%7d%40sT%7d\n", 1, 1, 2 * count, count, "", 1);
    return text;
}

TEST(S3_errors_in_IGES_take_no_longer)
{
    only_once();
    for (int k = 0; k < 2; k++)
        check_proportion(iges_of_errors(FEW, k), iges_of_errors(4 * FEW, k), BATTEN_FORMAT_IGES,
                         false, "errors");
}
