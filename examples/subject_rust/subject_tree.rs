//! A subject of topic tree in Rust, without its standard library: the codes of Succinct Opacity Micromaps, by a walk over
//! the map with an explicit count of what is left.
#![no_std]

use core::slice;

extern "C" {
    fn abort() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe { abort() }
}

/// The first fields of mmverify_subject.h's mmverify_subject_t, up to tree_lookup.
#[repr(C)]
pub struct Subject {
    abi: u32,
    size: u32,
    name: *const u8,
    max_level: u32,
    flags: u32,
    before_trees: [usize; 5],
    tree_encode: extern "C" fn(u32, u32, *const u8, *mut u8, usize) -> usize,
    tree_decode: extern "C" fn(u32, u32, *const u8, usize, *mut u8) -> i32,
    tree_lookup: extern "C" fn(u32, u32, *const u8, usize, *const u32, *mut u8, usize),
}
unsafe impl Sync for Subject {}

const TREE_STREAM: u32 = 2;

// ---- numbers of `bits` bits, packed from the least significant bit of each byte on

fn get(bytes: &[u8], bits: u32, k: usize) -> u8 {
    let at = k * bits as usize;
    bytes[at / 8] >> (at % 8) & ((1 << bits) - 1)
}

fn put(bytes: &mut [u8], bits: u32, k: usize, value: u8) {
    let at = k * bits as usize;
    bytes[at / 8] |= value << (at % 8);
}

fn bytes_of(bits: u32, count: usize) -> usize {
    (count * bits as usize + 7) / 8
}

fn states(level: u32) -> usize {
    1 << (2 * level)
}

// ---- encoding

fn alike(map: &[u8], bits: u32, level: u32, first: usize) -> bool {
    let state = get(map, bits, first);
    (1..states(level)).all(|k| get(map, bits, first + k) == state)
}

/// Nodes and leaves so far.
#[derive(Clone, Copy)]
struct Place {
    nodes: usize,
    leaves: usize,
}

fn count(map: &[u8], bits: u32, level: u32, first: usize) -> Place {
    if alike(map, bits, level, first) {
        return Place { nodes: 1, leaves: 1 };
    }
    let mut all = Place { nodes: 1, leaves: 0 };
    for child in 0..4 {
        let below = count(map, bits, level - 1, first + child * states(level - 1));
        all.nodes += below.nodes;
        all.leaves += below.leaves;
    }
    all
}

fn write(map: &[u8], bits: u32, level: u32, first: usize, tree: &mut [u8], data: &mut [u8], at: &mut Place) {
    let leaf = alike(map, bits, level, first);
    put(tree, 1, at.nodes, !leaf as u8);
    at.nodes += 1;
    if leaf {
        put(data, bits, at.leaves, get(map, bits, first));
        at.leaves += 1;
        return;
    }
    for child in 0..4 {
        write(map, bits, level - 1, first + child * states(level - 1), tree, data, at);
    }
}

extern "C" fn tree_encode(level: u32, bits: u32, map: *const u8, code: *mut u8, capacity: usize) -> usize {
    let map = unsafe { slice::from_raw_parts(map, bytes_of(bits, states(level))) };
    let all = count(map, bits, level, 0);
    let tree_bytes = bytes_of(1, all.nodes);
    let size = tree_bytes + bytes_of(bits, all.leaves);
    if capacity < size {
        return size;
    }
    let code = unsafe { slice::from_raw_parts_mut(code, size) };
    code.fill(0);
    let (tree, data) = code.split_at_mut(tree_bytes);
    write(map, bits, level, 0, tree, data, &mut Place { nodes: 0, leaves: 0 });
    size
}

// ---- decoding

/// Nodes of the tree that the bytes begin with; none if they end before it does.
fn length(tree: &[u8]) -> Option<usize> {
    let mut owed = 1;
    let mut nodes = 0;
    while owed > 0 {
        if nodes == 8 * tree.len() {
            return None;
        }
        if get(tree, 1, nodes) == 1 {
            owed += 3;
        } else {
            owed -= 1;
        }
        nodes += 1;
    }
    Some(nodes)
}

fn only_zeros(bytes: &[u8], from: usize) -> bool {
    (from..8 * bytes.len()).all(|t| get(bytes, 1, t) == 0)
}

fn read(tree: &[u8], data: &[u8], bits: u32, level: u32, first: usize, at: &mut Place, map: &mut [u8]) -> bool {
    let inner = get(tree, 1, at.nodes) == 1;
    at.nodes += 1;
    if !inner {
        let state = get(data, bits, at.leaves);
        at.leaves += 1;
        for k in 0..states(level) {
            put(map, bits, first + k, state);
        }
        return true;
    }
    if level == 0 {
        return false;
    }
    for child in 0..4 {
        if !read(tree, data, bits, level - 1, first + child * states(level - 1), at, map) {
            return false;
        }
    }
    // Or it would have been a leaf.
    !alike(map, bits, level, first)
}

fn decode(level: u32, bits: u32, code: &[u8], map: &mut [u8]) -> Option<()> {
    let nodes = length(code)?;
    let leaves = nodes - nodes / 4;
    let tree_bytes = bytes_of(1, nodes);
    if code.len() != tree_bytes + bytes_of(bits, leaves) {
        return None;
    }
    let (tree, data) = code.split_at(tree_bytes);
    if !only_zeros(tree, nodes) || !only_zeros(data, leaves * bits as usize) {
        return None;
    }
    map.fill(0);
    let right = read(tree, data, bits, level, 0, &mut Place { nodes: 0, leaves: 0 }, map);
    right.then_some(())
}

extern "C" fn tree_decode(level: u32, bits: u32, code: *const u8, code_size: usize, map: *mut u8) -> i32 {
    let code = unsafe { slice::from_raw_parts(code, code_size) };
    let map = unsafe { slice::from_raw_parts_mut(map, bytes_of(bits, states(level))) };
    decode(level, bits, code, map).is_some() as i32
}

// ---- Algorithm 3

fn state_at(mut level: u32, bits: u32, tree: &[u8], data: &[u8], index: u32) -> u8 {
    let mut at = Place { nodes: 0, leaves: 0 };
    while get(tree, 1, at.nodes) == 1 {
        at.nodes += 1;
        level -= 1;
        let mut passed = index >> (2 * level) & 3;
        while passed > 0 {
            if get(tree, 1, at.nodes) == 1 {
                passed += 4;
            } else {
                at.leaves += 1;
            }
            passed -= 1;
            at.nodes += 1;
        }
    }
    get(data, bits, at.leaves)
}

extern "C" fn tree_lookup(
    level: u32,
    bits: u32,
    code: *const u8,
    code_size: usize,
    index: *const u32,
    state: *mut u8,
    count: usize,
) {
    let code = unsafe { slice::from_raw_parts(code, code_size) };
    let indices = unsafe { slice::from_raw_parts(index, count) };
    let answers = unsafe { slice::from_raw_parts_mut(state, count) };
    if let Some(nodes) = length(code) {
        let (tree, data) = code.split_at(bytes_of(1, nodes));
        for (answer, &index) in answers.iter_mut().zip(indices) {
            *answer = state_at(level, bits, tree, data, index);
        }
    }
}

static SUBJECT: Subject = Subject {
    abi: 1,
    size: core::mem::size_of::<Subject>() as u32,
    name: b"the example of a tree in Rust\0".as_ptr(),
    max_level: 12,
    flags: TREE_STREAM,
    before_trees: [0; 5],
    tree_encode,
    tree_decode,
    tree_lookup,
};

#[no_mangle]
pub extern "C" fn mmverify_subject_v1() -> *const Subject {
    &SUBJECT
}
