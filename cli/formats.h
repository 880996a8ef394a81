/* The table of formats, for the help, and formats by the word that names them. */
#ifndef CLI_FORMATS_H
#define CLI_FORMATS_H
#include "command.h"

/* What `batten help formats` says. */
void formats_manual(batten_text *text);
/* The format that an option names; AUTO when it was not given. False with a complaint for a
 * word that names none. */
bool formats_option(const char *of, const arguments *given, const char *name,
                    batten_format *format);

#endif
