/*
 * How the cost of a file grows: `batten-bench-files` lists the kinds of content;
 * `batten-bench-files FORMAT CONTENT N write|read PATH` writes n things to a file, reads them
 * back, and prints how many bytes the file has and by how many the peak of the process grew.
 * bench/files runs them all, and counts instructions.
 */
#define _XOPEN_SOURCE 700
#include <batten/batten.h>

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "bench: %s\n", batten_message());
    exit(1);
}

static void *room(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (!memory)
        exit(1);
    return memory;
}

/* Numbers with as many digits as measured ones have in memory. */
static double wave(int i)
{
    return 10 * sin(0.7 * i) + 1e-3 * i;
}

/* ---- models ---- */

static void fill_points(double *points, int count)
{
    for (int i = 0; i < count; i++) {
        points[3 * i] = wave(i);
        points[3 * i + 1] = wave(i + 1);
        points[3 * i + 2] = wave(7 * i) / 20;
    }
}

/* Bicubic patches of 20 x 20 points. */
static void add_patches(batten_model *model, int n)
{
    enum { SIDE = 20, DEGREE = 3 };
    double knots[SIDE + DEGREE + 1], *points = room(3 * SIDE * SIDE, sizeof *points);
    for (int i = 0; i < SIDE + DEGREE + 1; i++)
        knots[i] = fmin(fmax(i - DEGREE, 0), SIDE - DEGREE) / (SIDE - DEGREE);
    const batten_axis axis = {DEGREE, SIDE, knots, false};
    for (int k = 0; k < n; k++) {
        batten_surface *surface = NULL;
        for (int i = 0; i < SIDE * SIDE; i++) {
            points[3 * i] = i / SIDE / 1.9 + wave(k);
            points[3 * i + 1] = i % SIDE / 1.9;
            points[3 * i + 2] = wave(i + k) / 20;
        }
        must(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
        must(batten_model_add(model, &(batten_object){.name = "patch",
                                                      .kind = BATTEN_OBJECT_SURFACE,
                                                      .surface = surface}));
        batten_surface_unref(surface);
    }
    free(points);
}

/* Each with a name, a layer, a group and a colour of its own. */
static void add_with_looks(batten_model *model, int k, const batten_object *plain)
{
    char name[32], layer[32], group[64];
    batten_object object = *plain;
    snprintf(name, sizeof name, "part %d", k);
    snprintf(layer, sizeof layer, "layer %d", k);
    snprintf(group, sizeof group, "group %d/inner %d", k / 10, k);
    object.name = name;
    object.layer = layer;
    object.group = group;
    object.has_colour = true;
    for (int i = 0; i < 3; i++)
        object.colour[i] = (k >> (4 * i) & 15) / 15.0;
    must(batten_model_add(model, &object));
}

static void add_curves(batten_model *model, int n)
{
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int k = 0; k < n; k++) {
        batten_curve *curve = NULL;
        const double points[] = {wave(k),     wave(k + 1), 0, wave(k + 2), wave(k + 3), 0,
                                 wave(k + 4), wave(k + 5), 0, wave(k + 6), wave(k + 7), 0};
        must(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots, &curve));
        add_with_looks(model, k, &(batten_object){.kind = BATTEN_OBJECT_CURVE, .curve = curve});
        batten_curve_unref(curve);
    }
}

/* A strip of triangles. */
static batten_mesh *strip(int n)
{
    double *points = room(3 * ((size_t)n + 2), sizeof *points);
    int *corners = room(3 * (size_t)n, sizeof *corners);
    batten_mesh *mesh = NULL;
    for (int i = 0; i < n + 2; i++) {
        points[3 * i] = i / 2 * 0.7;
        points[3 * i + 1] = i % 2;
        points[3 * i + 2] = wave(i) / 20;
    }
    for (int i = 0; i < n; i++) {
        corners[3 * i] = i;
        corners[3 * i + 1] = i + 1 + i % 2;
        corners[3 * i + 2] = i + 2 - i % 2;
    }
    must(batten_mesh_create(
        &(batten_mesh_parts){
            .vertex_count = n + 2, .points = points, .triangle_count = n, .corners = corners},
        &mesh));
    free(points);
    free(corners);
    return mesh;
}

static void add_mesh(batten_model *model, int n)
{
    batten_mesh *mesh = strip(n);
    must(batten_model_add(
        model, &(batten_object){.name = "strip", .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    batten_mesh_unref(mesh);
}

static void add_meshes(batten_model *model, int n)
{
    for (int k = 0; k < n; k++) {
        batten_mesh *mesh = strip(2);
        add_with_looks(model, k, &(batten_object){.kind = BATTEN_OBJECT_MESH, .mesh = mesh});
        batten_mesh_unref(mesh);
    }
}

static void add_instances(batten_model *model, int n)
{
    batten_model *definition = NULL;
    must(batten_model_create(0.001, &definition));
    add_mesh(definition, 2); /* formats take of these what they hold */
    add_curves(definition, 1);
    for (int k = 0; k < n; k++)
        add_with_looks(
            model, k,
            &(batten_object){.kind = BATTEN_OBJECT_INSTANCE,
                             .definition = definition,
                             .place = batten_affine_translation(wave(k), wave(k + 1), k)});
    batten_model_unref(definition);
}

static void add_cloud(batten_model *model, int n)
{
    double *points = room(3 * (size_t)n, sizeof *points);
    fill_points(points, n);
    must(batten_model_add(model, &(batten_object){.name = "cloud",
                                                  .kind = BATTEN_OBJECT_POINTS,
                                                  .point_count = n,
                                                  .points = points}));
    free(points);
}

/* Stations with twenty points each. */
static void add_offsets(batten_model *model, int n)
{
    enum { LINES = 20 };
    static const char *const names[LINES] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j",
                                             "k", "l", "m", "n", "o", "p", "q", "r", "s", "t"};
    batten_table_line lines[LINES];
    batten_table_station *stations = room((size_t)n, sizeof *stations);
    batten_table_point *points = room((size_t)n * LINES, sizeof *points);
    batten_offset_table *offsets = NULL;
    for (int j = 0; j < LINES; j++)
        lines[j] = (batten_table_line){.name = names[j]};
    for (int i = 0; i < n; i++) {
        stations[i] = (batten_table_station){
            .x = 1.3 * i, .point_count = LINES, .points = &points[i * LINES]};
        for (int j = 0; j < LINES; j++)
            points[i * LINES + j] = (batten_table_point){
                .x = 1.3 * i, .y = 1 + j + wave(i) / 20, .z = 0.3 * j, .line = j};
    }
    must(batten_offset_table_create(1, LINES, lines, n, stations, &offsets));
    must(batten_model_add(model, &(batten_object){.name = "hull",
                                                  .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                                  .offset_table = offsets}));
    batten_offset_table_unref(offsets);
    free(stations);
    free(points);
}

/* ---- formats that are read alone ---- */

static void put_pcd(FILE *file, int n)
{
    fprintf(
        file,
        "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %d\nHEIGHT 1\n"
        "POINTS %d\nDATA ascii\n",
        n, n);
    for (int i = 0; i < n; i++)
        fprintf(file, "%.17g %.17g %.17g\n", wave(i), wave(i + 1), wave(i + 2));
}

static void put_off(FILE *file, int n)
{
    fprintf(file, "OFF\n%d %d 0\n", n + 2, n);
    for (int i = 0; i < n + 2; i++)
        fprintf(file, "%.17g %d %.17g\n", i / 2 * 0.7, i % 2, wave(i));
    for (int i = 0; i < n; i++)
        fprintf(file, "3 %d %d %d\n", i, i + 1, i + 2);
}

/* A strip of faces of four corners on so many layers, of which the format has up to 1000. */
static void put_net(FILE *file, int n, int layers)
{
    fprintf(file, "FREE!ship\n2.6\n\n%d\n", layers);
    for (int k = 0; k < layers; k++)
        fprintf(file, "layer %d\n%d\n255\n1\n1\n1\n1\n1\n0\n0\n0\n0\n", k, k);
    fprintf(file, "0\n%d\n", 2 * n + 2);
    for (int i = 0; i < 2 * n + 2; i++)
        fprintf(file, "%.17g %.17g %d\n1\n0\n0\n", i / 2 * 0.7, wave(i), i % 2);
    fprintf(file, "0\n0\n%d\n", n);
    for (int i = 0; i < n; i++)
        fprintf(file, "4\n%d\n%d\n%d\n%d\n%d\n0\n", 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2,
                i % layers);
}

static void put_ftm(FILE *file, int n)
{
    put_net(file, n, 1);
}

static void put_ftm_layers(FILE *file, int n)
{
    put_net(file, n, n < 1000 ? n : 1000);
}

/* ---- the whole ---- */

static const struct {
    const char *name;
    void (*add)(batten_model *model, int n);
    void (*put)(FILE *file, int n);
} contents[] = {{"patches", add_patches, NULL},
                {"curves", add_curves, NULL},
                {"mesh", add_mesh, NULL},
                {"meshes", add_meshes, NULL},
                {"instances", add_instances, NULL},
                {"points", add_cloud, NULL},
                {"offsets", add_offsets, NULL},
                {"pcd", NULL, put_pcd},
                {"off", NULL, put_off},
                {"ftm", NULL, put_ftm},
                {"ftm-layers", NULL, put_ftm_layers}};
enum { CONTENTS = sizeof contents / sizeof contents[0] };

static double peak(void)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return 1024.0 * (double)used.ru_maxrss;
}

static batten_format format_of(const char *name)
{
    batten_format_facts facts;
    for (int k = 1; batten_format_about((batten_format)k, &facts); k++)
        if (strcmp(facts.name, name) == 0)
            return facts.format;
    fprintf(stderr, "bench: no format '%s'\n", name);
    exit(1);
}

static void write_content(batten_format format, size_t which, int n, const char *path)
{
    if (contents[which].put) {
        FILE *file = fopen(path, "w");
        if (!file)
            exit(1);
        contents[which].put(file, n);
        fclose(file);
        return;
    }
    batten_model *model = NULL;
    batten_write_options options = batten_write_defaults();
    options.format = format;
    must(batten_model_create(0.001, &model));
    contents[which].add(model, n);
    malloc_trim(0);
    const double before = peak();
    must(batten_write_file(model, path, &options, NULL));
    printf("%.0f ", peak() - before);
    batten_model_unref(model);
}

static void read_back(batten_format format, const char *path)
{
    batten_model *model = NULL;
    batten_read_options options = batten_read_defaults();
    options.format = format;
    const double before = peak();
    must(batten_read_file(path, &options, NULL, NULL, &model));
    printf("%.0f ", peak() - before);
    batten_model_unref(model);
}

int main(int count, char **arguments)
{
    size_t which = 0;
    if (count != 6) {
        for (size_t k = 0; k < CONTENTS; k++)
            puts(contents[k].name);
        return 0;
    }
    const batten_format format = format_of(arguments[1]);
    const char *path = arguments[5];
    while (which < CONTENTS && strcmp(contents[which].name, arguments[2]) != 0)
        which++;
    if (which == CONTENTS)
        return 1;
    if (strcmp(arguments[4], "write") == 0)
        write_content(format, which, atoi(arguments[3]), path);
    else
        read_back(format, path);
    struct stat about;
    if (stat(path, &about) != 0)
        return 1;
    printf("%lld\n", (long long)about.st_size);
    return 0;
}
