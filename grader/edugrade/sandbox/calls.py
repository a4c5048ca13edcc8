"""The system calls that a run may make, and the names of other system calls, as ``name:number on x86-64:number on 64-bit ARM``.

Calls that are in none of these tables are refused as well. A number above NEWEST is reported as unknown, so the C library uses an
older call.
"""

from __future__ import annotations

NEWEST = 462

_ALLOWED = """
read:0:63 write:1:64 readv:19:65 writev:20:66 pread64:17:67 pwrite64:18:68 preadv:295:69 pwritev:296:70 preadv2:327:286
pwritev2:328:287 lseek:8:62 close:3:57 close_range:436:436 dup:32:23 dup2:33:- dup3:292:24 pipe:22:-
pipe2:293:59 sendfile:40:71 copy_file_range:326:285 open:2:- openat:257:56 openat2:437:437 creat:85:- stat:4:- fstat:5:80
lstat:6:- newfstatat:262:79 statx:332:291 access:21:- faccessat:269:48 faccessat2:439:439 readlink:89:- readlinkat:267:78
getdents:78:- getdents64:217:61 statfs:137:43 fstatfs:138:44 getxattr:191:8 lgetxattr:192:9 fgetxattr:193:10 listxattr:194:11
llistxattr:195:12 flistxattr:196:13 mkdir:83:- mkdirat:258:34 rmdir:84:- unlink:87:- unlinkat:263:35 rename:82:-
renameat:264:38 renameat2:316:276 link:86:- linkat:265:37 symlink:88:- symlinkat:266:36 mknod:133:- mknodat:259:33
truncate:76:45 ftruncate:77:46 fallocate:285:47 fsync:74:82 fdatasync:75:83 sync_file_range:277:84 fadvise64:221:223
readahead:187:213 umask:95:166 getcwd:79:17 chdir:80:49 fchdir:81:50 mmap:9:222 munmap:11:215 mremap:25:216 mprotect:10:226
msync:26:227 madvise:28:233 mincore:27:232 mlock:149:228 munlock:150:229 mlock2:325:284 mlockall:151:230 munlockall:152:231
brk:12:214 membarrier:324:283
get_mempolicy:239:236 mbind:237:235 pkey_alloc:330:289 pkey_free:331:290 pkey_mprotect:329:288 fork:57:-
vfork:58:- execve:59:221 execveat:322:281 exit:60:93 exit_group:231:94 wait4:61:260 waitid:247:95 kill:62:129 tkill:200:130
tgkill:234:131 pidfd_open:434:434 pidfd_send_signal:424:424 rt_sigaction:13:134 rt_sigprocmask:14:135 rt_sigreturn:15:139
rt_sigpending:127:136 rt_sigtimedwait:128:137 rt_sigqueueinfo:129:138 rt_tgsigqueueinfo:297:240 rt_sigsuspend:130:133
sigaltstack:131:132 pause:34:- alarm:37:- getitimer:36:102 setitimer:38:103 restart_syscall:219:128 set_tid_address:218:96
set_robust_list:273:99 get_robust_list:274:100 rseq:334:293 futex:202:98 futex_waitv:449:449 arch_prctl:158:-
sched_yield:24:124 sched_getaffinity:204:123 sched_getparam:143:121 sched_getscheduler:145:120 sched_get_priority_max:146:125
sched_get_priority_min:147:126 sched_rr_get_interval:148:127 getpriority:140:141 getcpu:309:168 getpid:39:172 getppid:110:173
gettid:186:178 getpgrp:111:- getpgid:121:155 setpgid:109:154 getsid:124:156 setsid:112:157 getuid:102:174 geteuid:107:175
getgid:104:176 getegid:108:177 getresuid:118:148 getresgid:120:150 getgroups:115:158 capget:125:90 getrlimit:97:163
setrlimit:160:164 getrusage:98:165 times:100:153 sysinfo:99:179 uname:63:160 getrandom:318:278 time:201:- gettimeofday:96:169
clock_gettime:228:113 clock_getres:229:114 clock_nanosleep:230:115 nanosleep:35:101 timer_create:222:107 timer_settime:223:110
timer_gettime:224:108 timer_getoverrun:225:109 timer_delete:226:111 timerfd_create:283:85 timerfd_settime:286:86
timerfd_gettime:287:87 poll:7:- ppoll:271:73 select:23:- pselect6:270:72 epoll_create:213:- epoll_create1:291:20
epoll_ctl:233:21 epoll_wait:232:- epoll_pwait:281:22 epoll_pwait2:441:441 eventfd:284:- eventfd2:290:19 signalfd:282:-
signalfd4:289:74 sendmsg:46:211 recvfrom:45:207 recvmsg:47:212 recvmmsg:299:243 shutdown:48:210 getsockname:51:204
getpeername:52:205 getsockopt:55:209
"""

_LOOKED_AT = """
clone:56:220 clone3:435:435 prlimit64:302:261 prctl:157:167 ioctl:16:29 fcntl:72:25 socketpair:53:199 sendto:44:206
setsockopt:54:208
"""
"""Calls that are allowed only with some arguments; see `seccomp.py`."""

_OF_OWN_FILES = """
chmod:90:- fchmod:91:52 fchmodat:268:53 fchmodat2:452:452 utime:132:- utimes:235:- futimesat:261:- utimensat:280:88
"""
"""Calls that are allowed where the run sees only its own files, and everything else is read-only."""

_REFUSED = """
flock:73:32 chown:92:- fchown:93:55 lchown:94:- fchownat:260:54
setxattr:188:5 lsetxattr:189:6 fsetxattr:190:7 removexattr:197:14 lremovexattr:198:15
fremovexattr:199:16 socket:41:198 bind:49:200 connect:42:203 listen:50:201 accept:43:202 accept4:288:242 sendmmsg:307:269
sched_setaffinity:203:122 sched_setscheduler:144:119 sched_setparam:142:118 sched_setattr:314:274 sched_getattr:315:275
setpriority:141:140 ioprio_set:251:30 ioprio_get:252:31 inotify_init:253:- inotify_init1:294:26 inotify_add_watch:254:27
inotify_rm_watch:255:28 fanotify_init:300:262 fanotify_mark:301:263 memfd_create:319:279 memfd_secret:447:447 shmget:29:194
shmat:30:196 shmctl:31:195 semget:64:190 semop:65:193 semctl:66:191 msgget:68:186 msgsnd:69:189 msgrcv:70:188 mq_open:240:180
mq_unlink:241:181 ptrace:101:117 process_vm_readv:310:270 process_vm_writev:311:271 process_madvise:440:440
process_mrelease:448:448 pidfd_getfd:438:438 kcmp:312:272 splice:275:76 tee:276:77 vmsplice:278:75 setuid:105:146
setgid:106:144 setreuid:113:145 setregid:114:143 setresuid:117:147 setresgid:119:149 setgroups:116:159 setfsuid:122:151
setfsgid:123:152 capset:126:91 personality:135:92 seccomp:317:277 landlock_create_ruleset:444:444 landlock_add_rule:445:445
landlock_restrict_self:446:446 mount:165:40 umount2:166:39 pivot_root:155:41 chroot:161:51 open_tree:428:428
move_mount:429:429 fsopen:430:430 fsconfig:431:431 fsmount:432:432 fspick:433:433 mount_setattr:442:442
name_to_handle_at:303:264 open_by_handle_at:304:265 unshare:272:97 setns:308:268 bpf:321:280 perf_event_open:298:241
userfaultfd:323:282 io_uring_setup:425:425 io_uring_enter:426:426 io_uring_register:427:427 add_key:248:217
request_key:249:218 keyctl:250:219 init_module:175:105 finit_module:313:273 delete_module:176:106 kexec_load:246:104
kexec_file_load:320:294 reboot:169:142 swapon:167:224 swapoff:168:225 sethostname:170:161 setdomainname:171:162
settimeofday:164:170 clock_settime:227:112 clock_adjtime:305:266 adjtimex:159:171 acct:163:89 quotactl:179:60 syslog:103:116
sync:162:81 syncfs:306:267 vhangup:153:58 iopl:172:- ioperm:173:- modify_ldt:154:- set_mempolicy:238:237
migrate_pages:256:238 move_pages:279:239
"""
"""Refused calls with names, so that a report can name them."""


def _numbers(table: str, column: int) -> dict[str, int]:
    rows = (row.split(':') for row in table.split())
    return {row[0]: int(row[1 + column]) for row in rows if row[1 + column] != '-'}


def allowed(column: int, has_view: bool = False) -> dict[str, int]:
    """Return the numbers of the calls that a run may make with any arguments, by name.

    :param column: 0 for x86-64, 1 for 64-bit ARM.
    :param has_view: whether the run has its own view, in which all files outside its folder are read-only.
    """
    return _numbers(_ALLOWED + _OF_OWN_FILES * has_view, column)


def looked_at(column: int) -> dict[str, int]:
    """Return the numbers of the calls that a run may make with some arguments, by name."""
    return _numbers(_LOOKED_AT, column)


def name_of(number: int, column: int) -> str:
    """Return the name of a refused call, or a description with its number if the name is unknown."""
    known = {**_numbers(_REFUSED + _OF_OWN_FILES, column), **looked_at(column)}
    return next((name for name, each in known.items() if each == number), f'system call {number}')
