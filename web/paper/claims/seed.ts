/** Every random number of the studies is of this seed. */
export const studySeed = 16;
