/* What tracing reports of a face: notes, and failures that concern that face alone. */
#include "body/trace/trace.h"

#include <stdio.h>
#include <string.h>

static void entity_of(const bat_trace *trace, const bat_trace_face *face, char *entity,
                      size_t size)
{
    const char *name = trace->from->faces[face->from].name;
    char shown[BAT_SHOWN_SIZE];
    if (name[0])
        snprintf(entity, size, "face %d, %.80s", face->from + 1,
                 bat_shown(name, strlen(name), shown));
    else
        snprintf(entity, size, "face %d", face->from + 1);
}

void bat_trace_note(bat_trace *trace, const bat_trace_face *face, const char *text)
{
    char entity[128];
    entity_of(trace, face, entity, sizeof entity);
    batten_notes_add(trace->notes, "", 0, entity, "%s", text);
}

bool bat_trace_fails(bat_trace *trace, bat_trace_face *face, batten_status status)
{
    if (status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ||
        status == BATTEN_INCOMPLETE)
        return false;
    char entity[128];
    entity_of(trace, face, entity, sizeof entity);
    batten_notes_add(trace->notes, "", 0, entity, "left out: %s", batten_message());
    face->failed = true;
    trace->report.failed++;
    bat_trace_end_loops(&face->loops);
    return true;
}
