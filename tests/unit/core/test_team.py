"""A team of threads: who does which share changes nothing, and a member that keeps the leader waiting is left out for a while."""

import os
import threading
import time

import numba as nb
import numpy as np
import pytest
from pace import PATIENCE

from hugoniot.core import team

pytestmark = pytest.mark.skipif(not team.possible(), reason="no team on this system")


@nb.njit(nogil=True)
def work(row, share, of):
    for i in range(share, row.shape[0], of):
        row[i] = 0.999 * row[i] + 0.1 * (i + 1.0)


@nb.njit(nogil=True)
def lead(row, board, phases, threads):
    alone = 0
    for k in range(phases):
        shares = team.begin(board, k % 3, threads)
        for share in range(shares):
            work(row, share, threads)
        team.gather_team(board, threads)
        alone += shares > 1
    return alone


@nb.njit(nogil=True)
def serve(row, board, member, threads):
    phase = 0
    while True:
        phase = team.await_call(board, phase, member)
        command = board[1]
        if command != team.DISMISSED:
            work(row, member, threads)
        team.sign(board, member, phase)
        if command == team.DISMISSED:
            return


@pytest.mark.parametrize("threads", [2, 3])
def test_any_number_of_threads_gives_the_same_bits(threads):
    rows = np.ones((2, 3000))
    for _ in range(500):
        work(rows[0], 0, 1)
    board = team.board(threads)
    members = [threading.Thread(target=serve, args=(rows[1], board, member, threads), daemon=True) for member in range(1, threads)]
    for one in members:
        one.start()
    alone = lead(rows[1], board, 500, threads)
    team.call(board, team.DISMISSED)
    team.gather_team(board, threads)
    for one in members:
        one.join(timeout=PATIENCE)
    assert not any(one.is_alive() for one in members)
    assert np.array_equal(rows[0], rows[1])
    assert alone >= 3       # each command once, to know how long it takes


def test_a_member_that_keeps_the_leader_waiting_is_left_out_for_ten_times_as_long():
    board, row, pause = team.board(2), np.ones(3000), 0.05
    assert lead(row, board, 3, 2) == 3

    def late():
        while board[0] == 0:
            time.sleep(1e-4)
        time.sleep(pause)
        team.sign(board, 1, board[0])

    member = threading.Thread(target=late, daemon=True)
    member.start()
    assert lead(row, board, 1, 2) == 0
    member.join(timeout=PATIENCE)
    until = board[team.SHARE_AGAIN] * 1e-9
    assert until - board[team.BEGAN] * 1e-9 > 11.0 * 0.9 * pause       # the wait itself, and the rest
    board[team.SHARE_AGAIN] = 2**62        # however slow this machine is
    assert lead(row, board, 100, 2) == 100 and board[0] == 1


def test_waiting_within_credit_is_borne():
    board = team.board(2)
    team.begin(board, 0, 2)
    team.gather_team(board, 2)
    board[team.ACCOUNT] = 10**15
    team.call(board, 0)
    team.sign(board, 1, board[0])
    team.gather_team(board, 2)
    assert board[team.SHARE_AGAIN] == 0 and board[team.ACCOUNT] == team.CREDIT


def lose(board, nanoseconds):
    """A shared phase that takes so much longer than it does alone."""
    team.call(board, 0)
    board[team.BEGAN] = time.clock_gettime_ns(time.CLOCK_MONOTONIC) - nanoseconds
    team.sign(board, 1, board[0])
    team.gather_team(board, 2)


def test_each_rest_without_a_gain_between_is_twice_as_long():
    board, loss = team.board(2), 4_000_000
    rests = []
    for _ in range(8):
        lose(board, loss)
        rests.append((board[team.SHARE_AGAIN] - board[team.BEGAN]) / loss - 1.0)
    for k, rest in enumerate(rests):      # however long the machine kept this test from going on, that much longer the rest is
        assert rest >= min(team.REST * 2**k, team.LONGEST_REST / loss)
    lose(board, -2 * team.CREDIT)
    assert board[team.ACCOUNT] == team.CREDIT and board[team.RESTING] == team.REST
    lose(board, 10**10)                   # ten seconds: more than the longest rest, which it is
    assert board[team.SHARE_AGAIN] - board[team.BEGAN] >= (team.REST + 1) * 10**10 - team.REST * team.CREDIT


def test_a_march_during_a_rest_has_no_other_threads():
    one = team.team_of(2, 10, 10)
    if one.threads == 1:
        pytest.skip("one processor")
    seen = []

    def stand_by(member, phase, plan, crew):
        seen.append(member)
        serve(plan, crew.board, member, crew.threads)

    row = np.ones(3000)
    with team.at_work(one, stand_by, row):
        assert lead(row, one.board, 30, 2) < 30
    assert seen == [1]
    again = one.board[team.SHARE_AGAIN] = team.NEVER - 1
    with team.at_work(one, stand_by, row):
        assert lead(row, one.board, 30, 2) == 30
    assert seen == [1] and one.board[team.SHARE_AGAIN] == again
    alone = np.ones(3000)
    for _ in range(60):
        work(alone, 0, 1)
    assert np.array_equal(row, alone)


def test_a_leader_does_not_wait_for_threads_that_have_not_begun():
    board, row = team.board(2), np.ones(3000)
    board[2 * team.LINE] = team.AWAY
    assert lead(row, board, 100, 2) == 100 and board[team.ACCOUNT] == 0 and board[0] == 0
    board[2 * team.LINE] = 0
    assert team.begin(board, 0, 2) == 1


def test_few_zones_or_one_thread_make_no_team():
    assert team.team_of(1, 10**6, 10).threads == team.team_of(8, 9, 10).threads == 1


def test_members_that_need_every_core_have_one_each():
    cores = os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else set()
    if len(cores) < 2:
        pytest.skip("one core, or a system that does not say which")
    seen, one = {}, team.Team(len(cores), team.board(len(cores)))

    def stand_by(member, phase, plan, crew):
        seen[member] = os.sched_getaffinity(0)
        serve(plan, crew.board, member, crew.threads)

    with team.at_work(one, stand_by, np.ones(10)):
        seen[0] = os.sched_getaffinity(0)
    assert all(len(own) == 1 for own in seen.values()) and set().union(*seen.values()) == cores
    assert os.sched_getaffinity(0) == cores
    assert team.cores_for(len(cores) - 1) == team.cores_for(len(cores) + 1) == []
