"""The type variables in the signatures of publishers, subscriptions, clients and services, as annotations name them."""

from __future__ import annotations

from typing import TypeVar

MsgType = TypeVar('MsgType')
SrvType = TypeVar('SrvType')
SrvTypeRequest = TypeVar('SrvTypeRequest')
SrvTypeResponse = TypeVar('SrvTypeResponse')
