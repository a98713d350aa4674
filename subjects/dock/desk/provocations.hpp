// Provocations: ways to repeat a question that a subject may answer otherwise. The tables that say when each is
// tried are in numbers.cpp and blobs.cpp.
#pragma once

#include "subjects/dock/desk/batch.hpp"
#include "subjects/dock/desk/blob.hpp"

namespace mmverify::dock {

/// Asks in pieces of another size, and so at other places and addresses (numbers.cpp). Domain: most <= 4096.
void in_pieces(const Batch& batch, std::size_t size, std::size_t most = batch_size);

// Orders and sizes of batches (orders.cpp): no element may depend on its neighbours.

/// Asks with neighbours far apart, then the same from two threads.
void in_another_order(const Batch& batch);
/// Asks runs of one element with a different one at each inner place: equal ends need not mean an equal middle.
void in_runs(const Batch& batch);
/// Asks batches of each size up to one more than the longest vector, with the answers at a guard page.
void in_each_size(const Batch& batch);
/// Asks in descending order, every other element first, and in long runs of one element.
void in_orders_of_callers(const Batch& batch);
/// Repeats the elements until a batch is large; then in two threads, one of them with its elements rotated.
void many_times_over(const Batch& batch);
/// Moves each array, and the answers, to different addresses modulo 64.
void at_other_places(const Batch& batch);
/// Asks elements of a short code, or in the blob itself, in all of these ways, and each code after each other one.
void in_each_size(const Blob& blob);

// Neighbours (neighbours.cpp): questions right after others that differ in one argument. A cache that ignores an
// argument is wrong then.

/// Asks each element right after the same at another level; an index is shortened to be valid there.
void after_another_level(const Batch& batch);
/// Asks right after an element of the level before with the same first number, and keeps this level's batch.
void after_the_level_before(const Batch& batch);
/// Asks elements, together and one by one, right after others that differ in one number or one bit only.
void after_neighbours(const Batch& batch);
/// Asks the first elements, together and one by one, right after the same in each other valid format; and elements
/// that an earlier batch had in another format, right after that.
void after_another_format(const Batch& batch);
void after_another_format(const Blob& blob);
/// Asks right after earlier questions in another format, the last one and all on the same bytes; keeps this one.
void after_kept_formats(const Blob& blob);
/// Asks after bytes that a cache may mistake for these. Domain: any bytes are a map or block for the question.
void after_like_ones(const Blob& blob);
/// Asks after the same bytes as a map of the level below. Domain: as after_like_ones(); the map was taken.
void after_the_level_below(const Blob& blob);

// Rooms and places of a blob's answer (rooms.cpp).

/// Asks for a code with little room, and with more than it needs.
void in_other_rooms(const Blob& blob);
/// Moves a short map or code, and its answer, to each place.
void at_other_places(const Blob& blob);

/// Asks over outputs that hold other answers, or the right one in part (priors.cpp).
void over_answers(const Batch& batch);
void over_answers(const Blob& blob);

/// Asks from two threads, then with one thread's elements rotated by half their number (two_questions.cpp).
void from_threads(const Batch& batch);
/// Asks from two threads, then with an earlier question to the entry point in the second thread.
void from_threads(const Blob& blob);
/// Asks in one thread, and the first batches of earlier levels and formats in another one; keeps this one.
void beside_another_kind(const Batch& batch);

/// Asks as other callers do: with memory that is theirs for the call only, below 2 and 4 GiB too, and in each
/// manner (circumstances.cpp).
void in_circumstances(const Batch& batch);
void in_circumstances(const Blob& blob);

/// Asks with one array for two inputs that are equal (one_array.cpp).
void with_one_array(const Batch& batch);
void with_one_array(const Blob& blob);

/// Asks while another thread writes the bytes next to the output (beside.cpp).
void beside_a_writer(const Batch& batch);
void beside_a_writer(const Blob& blob);

/// Asks from many new threads that are in the subject at once (many_threads.cpp).
void from_many_threads(const Batch& batch);
void from_many_threads(const Blob& blob);

}  // namespace mmverify::dock
