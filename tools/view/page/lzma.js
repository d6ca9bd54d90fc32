// LZMA as `xz --format=lzma` writes it: a fifth fewer bytes than gzip for the module.   I. Pavlov, LZMA specification (2015)

const ONE = 2048, FASTNESS = 5; // probabilities are 2048ths, and move by a 32nd to what was seen
const TOP = 2 ** 24; // below it the range takes another byte

const odds = (count) => new Uint16Array(count).fill(ONE / 2);

class RangeDecoder {
  constructor(bytes, at) {
    Object.assign(this, { bytes, at: at + 1, range: 0xffffffff, code: 0 });
    for (let i = 0; i < 4; ++i) this.code = this.code * 256 + bytes[this.at++];
  }

  more() {
    if (this.range >= TOP) return;
    this.range *= 256;
    this.code = this.code * 256 + this.bytes[this.at++];
  }

  /** One bit whose probability to be 0 stands at table[i]. */
  bit(table, i) {
    const bound = (this.range >>> 11) * table[i];
    const bit = this.code < bound ? 0 : 1;
    if (bit === 0) {
      this.range = bound;
      table[i] += (ONE - table[i]) >> FASTNESS;
    } else {
      this.range -= bound;
      this.code -= bound;
      table[i] -= table[i] >> FASTNESS;
    }
    this.more();
    return bit;
  }

  /** A number of so many bits, the highest first, each as likely 0 as 1. */
  even(count) {
    let number = 0;
    for (let i = 0; i < count; ++i) {
      this.range >>>= 1;
      const bit = this.code >= this.range ? 1 : 0;
      this.code -= bit * this.range;
      number = number * 2 + bit;
      this.more();
    }
    return number;
  }

  /** The highest bit first; each has a probability for every way that leads to it. */
  tree(table, from, count) {
    let node = 1;
    for (let i = 0; i < count; ++i) node = node * 2 + this.bit(table, from + node);
    return node - (1 << count);
  }

  /** The lowest bit first. */
  reverseTree(table, from, count) {
    let node = 1, number = 0;
    for (let i = 0; i < count; ++i) {
      const bit = this.bit(table, from + node);
      node = node * 2 + bit;
      number += bit << i;
    }
    return number;
  }
}

class Lengths {
  constructor() {
    Object.assign(this, { kind: odds(2), short: odds(128), middle: odds(128), long: odds(256) });
  }

  read(coder, place) {
    if (!coder.bit(this.kind, 0)) return 2 + coder.tree(this.short, place * 8, 3);
    if (!coder.bit(this.kind, 1)) return 10 + coder.tree(this.middle, place * 8, 3);
    return 18 + coder.tree(this.long, 0, 8);
  }
}

class Distances {
  constructor() {
    Object.assign(this, { slots: odds(4 * 64), near: odds(128), low: odds(16) });
  }

  read(coder, length) {
    const slot = coder.tree(this.slots, Math.min(length - 2, 3) * 64, 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1, start = (2 + (slot & 1)) * 2 ** bits;
    if (slot < 14) return start + coder.reverseTree(this.near, start - slot, bits);
    return start + coder.even(bits - 4) * 16 + coder.reverseTree(this.low, 0, 4);
  }
}

/** A byte by itself; after a match the byte that would have followed is a hint. */
function literal(coder, table, from, hint) {
  let node = 1;
  for (let asHinted = hint >= 0; node < 256;) {
    const expected = asHinted ? (hint >> 7) & 1 : 0;
    const bit = coder.bit(table, from + (asHinted ? (1 + expected) * 256 : 0) + node);
    asHinted = asHinted && bit === expected;
    hint <<= 1;
    node = node * 2 + bit;
  }
  return node & 255;
}

/** The bytes of a stream whose header tells their number (13 bytes: parameters, 4 of the dictionary's size, 8 of that number). */
export function unpackLzma(bytes) {
  const context = bytes[0] % 9, places = Math.floor(bytes[0] / 9) % 5, placeMask = (1 << Math.floor(bytes[0] / 45)) - 1;
  const out = new Uint8Array(new DataView(bytes.buffer, bytes.byteOffset).getUint32(5, true));
  const coder = new RangeDecoder(bytes, 13);
  const literals = odds(0x300 << (context + places)), lengths = new Lengths(), repeatLengths = new Lengths(), distances = new Distances();
  const isMatch = odds(192), isRepeat = odds(12), isOlder = odds(12), isLong = odds(192), isSecond = odds(12), isThird = odds(12);
  let state = 0, last = [0, 0, 0, 0], at = 0; // `last`: the four distances that were used before, less one

  while (at < out.length) {
    const place = at & placeMask, at16 = state * 16 + place;
    if (!coder.bit(isMatch, at16)) {
      const before = at > 0 ? out[at - 1] : 0;
      const from = 0x300 * (((at & ((1 << places) - 1)) << context) + (before >> (8 - context)));
      out[at] = literal(coder, literals, from, state >= 7 ? out[at - last[0] - 1] : -1);
      at += 1;
      state = state < 4 ? 0 : state - (state < 10 ? 3 : 6);
      continue;
    }
    let length = 1;
    if (!coder.bit(isRepeat, state)) {
      length = lengths.read(coder, place);
      last = [distances.read(coder, length), last[0], last[1], last[2]];
      state = state < 7 ? 7 : 10;
    } else {
      let older = 0;
      if (coder.bit(isOlder, state)) older = coder.bit(isSecond, state) ? 2 + coder.bit(isThird, state) : 1;
      const isShort = older === 0 && !coder.bit(isLong, at16);
      last = [last[older], ...last.filter((_, i) => i !== older)];
      if (!isShort) length = repeatLengths.read(coder, place);
      state = state < 7 ? (isShort ? 9 : 8) : 11;
    }
    if (last[0] >= at) throw new Error('the module is damaged');
    for (const end = Math.min(out.length, at + length); at < end; ++at) out[at] = out[at - last[0] - 1];
  }
  return out;
}
