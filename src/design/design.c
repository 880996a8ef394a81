#include <batten/design.h>

batten_design_options batten_design_defaults(void)
{
    return (batten_design_options){.size = sizeof(batten_design_options), .file_name = ""};
}
