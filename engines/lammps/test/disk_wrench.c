/* Prints force and torque of the dry friction of a disk: disk_wrench MU RADIUS LOAD SPEED SPIN */
#include "tribos.h"

#include <stdio.h>
#include <stdlib.h>

int main(int count, char **words)
{
    if (count != 6)
        return 1;
    const tribos_round_f64 disk = {.coefficient = atof(words[1]), .radius = atof(words[2])};
    const tribos_twist_f64 motion = {.x = atof(words[4]), .y = 0, .spin = atof(words[5])};
    tribos_wrench_f64 wrench;
    if (tribos_disk_wrench_f64(&disk, atof(words[3]), &motion, &wrench) != TRIBOS_STATUS_OK)
        return 2;
    printf("%.17g %.17g\n", wrench.x, wrench.torque);
    return 0;
}
