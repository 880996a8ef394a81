/* Read a STEP file, make triangles of its bodies, and write them for a printer. */
#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

/* The two walls of a pipe, as a STEP file in millimetres. */
static void write_pipe(const char *path)
{
    const double radii[] = {8, 10}, length = 40;
    const batten_frame below = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    batten_model *model = NULL;
    must(batten_model_create(0.001, &model));
    for (int i = 0; i < 2; i++) {
        batten_surface *wall = NULL;
        batten_body *body = NULL;
        must(batten_surface_cylinder(&below, radii[i], length, &wall));
        must(batten_body_from_surface(i ? "outside" : "inside", wall, 1e-6, &body));
        const batten_object object = {
            .name = i ? "outside" : "inside", .kind = BATTEN_OBJECT_BODY, .body = body};
        must(batten_model_add(model, &object));
        batten_body_unref(body);
        batten_surface_unref(wall);
    }
    must(batten_write_file(model, path, NULL, NULL));
    batten_model_unref(model);
}

/* Make triangles of what the STEP file holds, say how they turned out, and save them as STL.
 * chord: how far they may be from the shape, in the unit of the file; 0: a thousandth of its
 * size. */
static void convert(const char *step, const char *stl, double chord)
{
    /* What was odd, approximated or left out is in the notes. */
    batten_notes *notes = NULL;
    batten_model *model = NULL, *flat = NULL, *meshes = NULL;
    must(batten_notes_create(100, &notes));
    must(batten_read_file(step, NULL, NULL, notes, &model));
    must(batten_model_flat(model, &flat)); /* parts of assemblies, where they stand */

    batten_mesh_options options = batten_mesh_defaults();
    options.chord = chord;
    must(batten_model_meshed(flat, &options, NULL, notes, &meshes));
    for (int i = 0; i < batten_model_count(meshes); i++) {
        const batten_object *object = batten_model_object(meshes, i);
        batten_mesh_facts facts;
        if (object->kind != BATTEN_OBJECT_MESH)
            continue;
        must(batten_mesh_check(object->mesh, &facts));
        printf("%s: area %.6g, %d edges at the rim, %s\n", object->name, facts.area,
               facts.rim_edges, facts.is_watertight ? "closed" : "open");
    }
    must(batten_write_file(meshes, stl, NULL, notes));
    for (int i = 0; i < batten_notes_count(notes); i++)
        printf("%s: %s\n", batten_notes_at(notes, i)->entity, batten_notes_at(notes, i)->text);

    batten_notes_free(notes);
    batten_model_unref(meshes);
    batten_model_unref(flat);
    batten_model_unref(model);
}

/* 08_step_to_mesh IN.step OUT.stl; without words a pipe that is made and removed here. */
int main(int count, char **words)
{
    const char *step = "08_pipe.step", *stl = "08_pipe.stl";
    if (count == 3) {
        convert(words[1], words[2], 0);
        return 0;
    }
    if (count != 1) {
        fprintf(stderr, "usage: %s [IN.step OUT.stl]\n", words[0]);
        return 2;
    }
    write_pipe(step);
    convert(step, stl, 0.01); /* mm: the unit of that file */
    remove(step);
    remove(stl);
    return 0;
}
