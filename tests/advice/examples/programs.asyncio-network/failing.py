import asyncio

asyncio.run(asyncio.open_connection('robot.local', 80))
