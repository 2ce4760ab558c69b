/** The seed of every random number of the studies. */
export const studySeed = 16;
