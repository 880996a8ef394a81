/* What the parts of the program `batten` share. */
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H
#include "complain.h"
#include "options.h"

#include <batten/design.h>
#include <batten/exchange.h>
#include <batten/text.h>

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_USAGE = 2, EXIT_PARTLY = 3 };

typedef struct command {
    const char *name;
    const char *usage;   /* behind the name: "IN -o OUT" */
    const char *summary; /* one line */
    const char *manual;  /* paragraphs */
    int least_files, most_files;
    int option_count;
    const option *options;
    /* The name of a feature whose parameters are further options; or NULL. */
    const char *feature;
    int (*run)(const arguments *given);
} command;

extern const command command_build, command_check, command_compare, command_convert,
    command_draw, command_eval, command_fair, command_fit, command_hydrostatics, command_info,
    command_measure;

/* Every command that works has it; answers are the same for any number. */
#define THREADS_OPTION                                                  \
    {                                                                   \
        "threads", 0, OPTION_VALUE, "N",                                \
            "work on 1 to 64 threads (as many as there are processors)" \
    }
enum { MOST_THREADS = 64 };

/* All commands, for those that speak of them. */
typedef struct {
    int count;
    const command *const *at;
} command_table;

/* Is it one of the command's own options? */
bool command_has_option(const command *c, const char *name);
/* The feature whose parameters are options: that of the command, or `choice` (below); NULL when
 * there is none. */
const batten_feature *command_feature(const command *c, const char *choice);
/* The options of a command and the parameters of its feature in one table, yours to
 * batten_release; NULL without memory. `choice`: another feature instead, with or without
 * settings (method.h), or NULL. */
option *command_options(const command *c, const char *choice, int *count);

/* What is to be said of the units of those values; NULL for nothing. */
const char *command_value_units(int count, const option *options);

/* ---- the running job: progress on a terminal, Ctrl-C ---- */

/* Catch the signals and say whether progress may be shown. threads: 0 for all processors. */
void job_begin(bool quiet, int threads);
/* Was that asked for? Remarks are not shown then either, but warnings are. */
bool job_is_quiet(void);
/* The job to hand to the library. */
const batten_job *job_get(void);
/* Wipe the progress line. */
void job_end(void);
/* 128 + the signal that came, or `otherwise`. */
int job_exit(int otherwise);

/* ---- input and output ---- */

/* Show all notes on standard error, remarks unless that is quiet. Notes of a design that the
 * command made itself have no file, and no place. */
void notes_show(const batten_notes *notes);
/* Of a failure: without the note that the message, which output_failed prints, says again. */
void failed_show(const batten_notes *notes);
void notes_json(batten_text *text, const batten_notes *notes);

/* Read `file`, `file#name` or `-` into a model, as the format; AUTO: by its content. The exit
 * status: EXIT_DONE, EXIT_PARTLY with a model, EXIT_FAILED without. */
int input_read(const char *file, batten_format format, batten_notes *notes,
               batten_model **model);
/* The file part of "file#name", yours to release, and the name or NULL. A file that exists
 * under the whole name is meant as it stands; the hash is the last one behind a file that
 * exists. */
batten_status input_split(const char *argument, char **file, const char **name);

/* In designs that a command makes, the file is a feature with its own name, so that messages
 * speak of it; with "./" before what could be the name of another feature. Add that name, in
 * quotes. */
void input_name_add(batten_text *text, const char *argument);
/* Add the feature that reads the file. */
void input_add(batten_text *text, const char *argument);

/* Print and free the text; EXIT_FAILED with a complaint when standard output refuses it. */
int output_print(batten_text *text);
/* Would writing `output` overwrite the file that is read, under whatever name? Then true, with
 * a complaint. */
bool output_is_input(const char *of, const char *input, const char *output);
/* Write bytes to the standard output, now. */
batten_status output_stream(const char *data, size_t size);
/* Save bytes to a file, or print them for "-". */
int output_save(const char *path, const char *data, size_t size);
/* The library's message, without the place ":5:39: " in a design that has no file. */
const char *message_shown(void);
/* Say why something failed: that message. */
int output_failed(const char *name, batten_status status);

#endif
