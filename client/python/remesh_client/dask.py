# SPDX-License-Identifier: Apache-2.0
"""Studies on a Dask cluster: many designs of one model, each remeshed from a near one.

    from distributed import Client
    from remesh_client.dask import map_designs
    designs = [{"radius": r, "rib.width": w} for r in (8, 9, 10) for w in (3, 4, 5)]
    futures = map_designs(Client("tcp://scheduler:8786"), base, designs)
    volumes = [future.result().figures["volume"] for future in futures]

Beside each worker runs a daemon; all daemons share a tier. The time of an edit goes with the nodes
that are made anew, and those go with the parameters that change. So a plan is made before anything
runs: a tree of least predicted cost over the base and all designs, along whose edges few and cheap
parameters change. A mesh depends on what it was remeshed from; since the plan depends on the base,
the designs and the options of `map_designs` alone, never on who is free, all ids and meshes are the
same whatever the number of workers. Dask gives a task to the worker that has the result of its
parent, whose daemon has the mesh in memory, and to another one that is idle.
"""
from __future__ import annotations

import itertools
import math
import os
import threading
import time
from collections import Counter
from dataclasses import dataclass, replace
from typing import Any, Iterator, Literal, Mapping, NamedTuple, Sequence, Union

import numpy as np
import numpy.typing as npt
from distributed import Client, Future, get_worker

from remesh_client import _requests
from remesh_client._connection import addresses_or_default
from remesh_client._farm import Search
from remesh_client.daemon import Daemon, connect
from remesh_client.edits import Value
from remesh_client.errors import Busy, Cancelled, NotFound, RemeshError, Unavailable
from remesh_client.part import Part
from remesh_client.v1 import revision_pb2

__all__ = ["DesignResult", "Plan", "learn_shares", "map_designs", "open_part", "plan_designs"]

_LEAST_SHARE = 0.01  # of the largest: no change is free
_FAR = 0.2  # by which a change across a parameter's whole range costs more than one nearby
_WAY = 4  # of the way from the base, one in so many counts beside the cost of an edit
_PASSING = (Unavailable, Busy, Cancelled, NotFound)  # the tier may not have its parent yet
_WAIT = 1.0  # s before another try
_COSTS = 1e6  # costs are compared in millionths, so that rounding decides nothing


@dataclass(frozen=True)
class DesignResult:
    """What a design's future gives; its mesh stays at the daemons (`open_part`).

    revision: id. parent: id of the revision that it was remeshed from. way: `LOCAL`, `MORPHED`, ...
    (report.proto). figures: all numbers of its Report by name, `nodes`, `nodes_kept`, `volume`,
    `quality.dihedral_min`. warnings: their codes. seconds: that the daemon computed for it; 0 where
    the base or another design has the same values. waited: s between the worker's request and its
    answer. replica: address of the daemon that answered.
    """

    revision: str
    parent: str
    way: str
    figures: Mapping[str, float]
    warnings: tuple[str, ...]
    seconds: float
    waited: float
    replica: str


@dataclass(frozen=True)
class Plan:
    """From which revision each design is remeshed.

    parents: of each design, the index of the one it is an edit of; -1: of the base. changes: of
    each, what that edit sets, by parameter; empty: the same values. from_base: what makes it of the
    base, where its parent failed. costs: of each edit as predicted, in the unit of the shares.
    depths: edits between the base and each. order: parents before children, branch by branch.
    """

    parents: tuple[int, ...]
    changes: tuple[dict[str, Value], ...]
    from_base: tuple[dict[str, Value], ...]
    costs: tuple[float, ...]
    depths: tuple[int, ...]
    order: tuple[int, ...]


class _Points:
    """What edits between the base, point 0, and the designs cost."""

    def __init__(self, values: Sequence[Mapping[str, Value]], shares: Mapping[str, float]) -> None:
        self._names = sorted(values[0])
        self._count = len(values)
        known = [share for share in shares.values() if share > 0] or [1.0]
        mean, least = math.fsum(known) / len(known), _LEAST_SHARE * max(known)
        self._shares = [max(shares.get(name, mean), least) for name in self._names]
        columns = [[point[name] for point in values] for name in self._names]
        self._keys = [np.unique([_key(value) for value in column], return_inverse=True)[1]
                      for column in columns]
        self._places = [_places(column) for column in columns]

    def costs(self, point: int) -> npt.NDArray[np.int64]:
        """Of the edits from one to each, in millionths."""
        total = np.zeros(self._count)
        for share, keys, places in zip(self._shares, self._keys, self._places):
            distance = np.abs(places - places[point])
            distance[np.isnan(distance)] = 1.0
            total += np.where(keys == keys[point], 0.0, share * (1.0 + _FAR * distance))
        return (_COSTS * total).round().astype(np.int64)


def plan_designs(base: Mapping[str, Value], designs: Sequence[Mapping[str, Value]], *,
                 depth: int = 8, shares: Mapping[str, float] | None = None) -> Plan:
    """A tree of low predicted cost, in which no design is more than `depth` edits from the base.

    base: its values of all parameters that designs set. designs: values by parameter; what one
    leaves out is the base's. depth: 1: all from the base. shares: by parameter what its change
    costs, as a share of the mesh that it makes anew; only ratios count; left out: alike.

    An edit costs the sum of the shares of what it changes, each up to a fifth more with the
    distance within that parameter's range. What every edit costs beside is the same for all trees.
    A chain is made one edit after another, so a minimum spanning tree alone would keep workers
    waiting: a design takes a parent further from the base where that saves more than a quarter of
    the way there. Raises KeyError for a parameter that the base has not, ValueError for a depth
    below 1.

    Source: the Prim-Dijkstra trade-off, Alpert, Hu, Huang, Kahng and Karger 1995.
    """
    if depth < 1:
        raise ValueError("a design is at least one edit from the base: depth >= 1")
    full = [dict(base)] + [{**base, **_known(design, base)} for design in designs]
    points = _Points(full, shares or {})
    count = len(full)
    parent, depths, ways = np.zeros((3, count), np.int64)
    costs = points.costs(0)
    keys, left = costs.copy(), np.arange(count) > 0
    for _ in designs:
        point = int(np.argmin(np.where(left, keys, np.iinfo(np.int64).max)))
        left[point] = False
        depths[point] = depths[parent[point]] + (costs[point] > 0)
        ways[point] = ways[parent[point]] + costs[point]
        found = points.costs(point)
        reached = found + ways[point] // _WAY
        nearer = left & (reached < keys) & ((found == 0) | (depths[point] < depth))
        keys[nearer], costs[nearer], parent[nearer] = reached[nearer], found[nearer], point
    return Plan(tuple(int(above) - 1 for above in parent[1:]),
                tuple(_changes(full[parent[point]], full[point]) for point in range(1, count)),
                tuple(_changes(full[0], values) for values in full[1:]),
                tuple(float(each) / _COSTS for each in costs[1:]),
                tuple(int(each) for each in depths[1:]),
                tuple(_branch_by_branch(parent)))


def _known(design: Mapping[str, Value], base: Mapping[str, Value]) -> Mapping[str, Value]:
    for name in design:
        if name not in base:
            raise KeyError(f"the base has no parameter {name!r}")
    return design


def _changes(old: Mapping[str, Value], new: Mapping[str, Value]) -> dict[str, Value]:
    return {name: new[name] for name in sorted(new) if _key(old[name]) != _key(new[name])}


def _key(value: Value) -> str:
    """Equal for equal values; 4 and 4.0 are."""
    return repr(value) if isinstance(value, str) else repr(float(value))


def _places(column: Sequence[Value]) -> npt.NDArray[np.float64]:
    """From 0 to 1 within the parameter's range; NaN for expressions."""
    places = np.array([np.nan if isinstance(value, str) else float(value) for value in column])
    numbers = places[~np.isnan(places)]
    extent = np.ptp(numbers) if len(numbers) else 0.0
    if extent > 0:
        places = (places - numbers.min()) / extent
    return places


def _branch_by_branch(parent: npt.NDArray[np.int64]) -> Iterator[int]:
    """Designs, each followed by all that are made of it. parent: of points; the base is 0."""
    children: dict[int, list[int]] = {}
    for point in range(len(parent) - 1, 0, -1):
        children.setdefault(int(parent[point]), []).append(point)
    ahead = children.get(0, [])
    while ahead:
        point = ahead.pop()
        yield point - 1
        ahead += children.get(point, [])


class _Site(NamedTuple):
    """How workers reach daemons: addresses beside those of REMESH_ADDRESS, arguments of connect."""

    addresses: tuple[str, ...]
    access: tuple[tuple[str, Any], ...]


class _Step(NamedTuple):
    """One design to make: of its parent, or of the base where that failed."""

    base: str
    change: Mapping[str, Value]
    from_base: Mapping[str, Value]
    timeout: float | None


_Outcome = Union[DesignResult, RemeshError]  # an error is returned, so that children see it


def map_designs(client: Client, base: Part | str, designs: Sequence[Mapping[str, Value]], *,
                addresses: Sequence[str] = (), depth: int = 8,
                shares: Mapping[str, float] | None = None, timeout: float | None = None,
                retries: int = 3, **access: Any) -> list[Future]:
    """Remeshes all designs on a cluster; futures of a DesignResult each, in the order of designs.

    client: a synchronous one. base: a revision that all daemons know, or its id; its options hold
    for all. designs: values by parameter, `{"radius": 8, "rib.width": 3}`; what one leaves out is
    the base's. No revision joins a design of the daemon. addresses: of all daemons. A worker asks
    the first of its own REMESH_ADDRESS, without that one of `addresses` by its name, and where that
    is not available the others. depth: most edits between the base and a design; more may save time
    but leave less to do side by side. shares: as of `plan_designs`; default: learned by
    `learn_shares`, for which this waits. timeout: s for each edit. retries: of what failed because
    no daemon was available or those there were busy. access: of rc.connect, `patience`, `tls_ca`,
    ...; files are the workers'.

    A model that cannot be meshed or time that is up is the exception of that design's future, a
    RemeshError; what was to be made of it is made of the base. (So ids depend on time only where a
    timeout passes.) A design for which no daemon can be had fails with Unavailable or Busy, and
    with it what was to be made of it; called again, this makes what is missing, for the daemons
    have the rest. The tasks of a worker that is lost are done by others.

    Raises NotFound for the base, KeyError for a parameter that it has not, ValueError for a depth
    below 1, Unavailable; waits for a first worker where there is none.
    """
    root, site = _id(base), _Site(tuple(addresses), tuple(sorted(access.items())))
    values = _base_values(client, root, designs, site, retries)
    if shares is None:
        shares = learn_shares(client, base, designs, addresses=addresses, timeout=timeout,
                              retries=retries, **access)
    plan = plan_designs(values, designs, depth=depth, shares=shares)
    outcomes: dict[int, Future] = {}
    for design in plan.order:
        step = _Step(root, plan.changes[design], plan.from_base[design], timeout)
        outcomes[design] = _submit(client, _remesh, step, outcomes.get(plan.parents[design]), site,
                                   retries=retries)
    return [_submit(client, _told, outcomes[design]) for design in range(len(designs))]


def learn_shares(client: Client, base: Part | str, designs: Sequence[Mapping[str, Value]], *,
                 measure: Literal["nodes", "seconds"] = "nodes", addresses: Sequence[str] = (),
                 timeout: float | None = None, retries: int = 3,
                 **access: Any) -> dict[str, float]:
    """What a change of each parameter costs, for `plan_designs`.

    Of every parameter that varies one edit of the base is made, to the value that most designs
    have. A parameter whose edit fails is left out; nothing is made where fewer than two vary.
    measure: `nodes`: the share of nodes that are not kept, the same every time; `seconds`: of
    computing, better where the clean-up of a coarse mesh takes most of it, but another number each
    time: keep them with the study and give them as `shares` whenever it is made again. Other
    arguments and errors: as of `map_designs`.
    """
    root, site = _id(base), _Site(tuple(addresses), tuple(sorted(access.items())))
    tried = _tried_values(_base_values(client, root, designs, site, retries), designs)
    if len(tried) < 2:
        return {}
    steps = [_Step(root, change, change, timeout) for change in tried]
    found = [future.result() for future in [
        _submit(client, _remesh, step, None, site, retries=retries) for step in steps]]
    return {name: (made.seconds if measure == "seconds"
                   else 1.0 - made.figures["nodes_kept"] / made.figures["nodes"])
            for change, made in zip(tried, found) if isinstance(made, DesignResult)
            for name in change}


def open_part(made: DesignResult, *, addresses: Sequence[str] = (), **access: Any) -> Part:
    """The Part of a result, for tasks that need its mesh; call it in a task.

    Arguments: as of `map_designs`. The mesh comes to the worker when it is asked for. Raises
    RemeshError.
    """
    daemon, route = _connection(_Site(tuple(addresses), tuple(sorted(access.items()))))
    return _opened(daemon, made.revision, route)


def _id(base: Part | str) -> str:
    return base if isinstance(base, str) else base.revision


def _submit(client: Any, *task: Any, **how: Any) -> Any:
    """A task, made again where it is asked for again: daemons answer from their cache."""
    return client.submit(*task, pure=False, **how)


def _base_values(client: Client, root: str, designs: Sequence[Mapping[str, Value]], site: _Site,
                 retries: int) -> dict[str, Value]:
    names = sorted({name for design in designs for name in design})
    values: dict[str, Value] = _submit(client, _values, root, names, site,
                                       retries=retries).result()
    return values


def _tried_values(base: Mapping[str, Value],
                  designs: Sequence[Mapping[str, Value]]) -> list[dict[str, Value]]:
    """For each parameter that varies, the value other than the base's that most designs have."""
    tried = []
    for name in sorted(base):
        others = {_key(design[name]): design[name] for design in designs
                  if name in design and _key(design[name]) != _key(base[name])}
        counts = Counter(_key(design[name]) for design in designs if name in design)
        if others:
            tried.append({name: others[max(others, key=lambda key: counts[key])]})
    return tried


# What follows runs on workers.


def _remesh(step: _Step, parent: _Outcome | None, site: _Site) -> _Outcome:
    """Raises what another try may mend, after a while; other errors are its outcome."""
    above = parent if isinstance(parent, DesignResult) else None
    revision = above.revision if above is not None else step.base
    change = step.change if above is not None or parent is None else step.from_base
    if above is not None and not change:
        return replace(above, seconds=0.0, waited=0.0)
    daemon, route = _connection(site)
    begun = time.monotonic()
    try:
        part = (_edited(daemon, revision, change, step.timeout, route) if change
                else _opened(daemon, revision, route))
    except _PASSING as why:
        time.sleep(why.retry_after or _WAIT)
        raise
    except RemeshError as why:
        return why
    seconds = part.report.seconds.total if change else 0.0
    return DesignResult(part.revision, part.parent, part.report.Way.Name(part.report.way)[4:],
                        _figures(part.report), tuple(each.code for each in part.warnings), seconds,
                        time.monotonic() - begun, _replica(daemon, part, route))


def _told(outcome: _Outcome) -> DesignResult:
    if isinstance(outcome, RemeshError):
        raise outcome
    return outcome


def _values(root: str, names: Sequence[str], site: _Site) -> dict[str, Value]:
    """The base's values of parameters, of the model or of features (`rib.width`)."""
    daemon, route = _connection(site)
    document = daemon._document(root, route)
    features = {feature["id"]: feature for feature in document["features"]}
    values: dict[str, Value] = {}
    for name in names:
        feature, dot, parameter = name.rpartition(".")
        owner = features.get(feature, {}) if dot else document
        found = owner.get("parameters", {}).get(parameter)
        if found is None:
            raise KeyError(f"the base has no parameter {name!r}")
        values[name] = found["value"] if isinstance(found, Mapping) else found
    return values


class _Thread(threading.local):
    """What each thread of a worker keeps: a stream is answered in order, so none share one."""

    def __init__(self) -> None:
        self.connections: dict[tuple[Any, ...], tuple[Daemon, str]] = {}


_thread = _Thread()


def _connection(site: _Site) -> tuple[Daemon, str]:
    """This worker's, and the route by which its own replica is asked first."""
    own = [each.strip() for each in os.environ.get("REMESH_ADDRESS", "").split(",")]
    addresses = addresses_or_default(list(dict.fromkeys(filter(None, [*own, *site.addresses])))
                                     or None)
    name = str(get_worker().address)
    key = (tuple(addresses), site.access, name)
    if key not in _thread.connections:
        daemon = connect(addresses, **dict(site.access))
        routes = (f"{name}/{number}" for number in itertools.count())
        _thread.connections[key] = daemon, next(
            route for route in routes
            if not any(own) or _first(daemon, route) == addresses[0])
    return _thread.connections[key]


def _edited(daemon: Daemon, revision: str, change: Mapping[str, Value], timeout: float | None,
            route: str) -> Part:
    return daemon._make(_requests.edit_of(revision, [change], {}, {}, file=False, with_mesh=False,
                                          content=None, on_progress=None, route=route), timeout)


def _opened(daemon: Daemon, revision: str, route: str) -> Part:
    reply = daemon._ask("GetRevision", revision_pb2.GetRevisionRequest(revision=revision), route)
    return Part(daemon, reply.revision, reply.report, durable=reply.durable, route=route)


def _replica(daemon: Daemon, part: Part, route: str) -> str:
    """The address of the one that answered."""
    carrier = part._exchange.carrier if part._exchange is not None else None
    return next((replica.address for replica in daemon._farm.replicas
                 if replica.stream is carrier), _first(daemon, route))


def _first(daemon: Daemon, route: str) -> str:
    """The address of the replica that is asked first."""
    return Search(daemon._farm, route).replica().address


def _figures(message: Any, prefix: str = "") -> dict[str, float]:
    """Its numbers by name, those of messages within as `seconds.total`."""
    figures: dict[str, float] = {}
    for field in message.DESCRIPTOR.fields:
        value = getattr(message, field.name)
        if field.label == field.LABEL_REPEATED or field.name == "diagnostics":
            continue
        if field.cpp_type == field.CPPTYPE_MESSAGE:
            figures |= _figures(value, f"{prefix}{field.name}.")
        elif field.cpp_type in (field.CPPTYPE_DOUBLE, field.CPPTYPE_UINT32):
            figures[prefix + field.name] = value
    return figures
